//! The server: hands the playground to browsers of this computer.

use super::site::File;
use super::{Fault, Site};
use http_body_util::Full;
use hyper::body::{Bytes, Incoming};
use hyper::header::{CACHE_CONTROL, CONTENT_TYPE, HeaderValue, X_CONTENT_TYPE_OPTIONS};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, Response, StatusCode};
use hyper_util::rt::TokioIo;
use std::convert::Infallible;
use std::future::ready;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::time::Duration;

/// Is how long nobody new is answered where the system hands out no more connections.
const PAUSE: Duration = Duration::from_millis(50);

/// Listens on the loopback address: no other computer can ask.
pub struct Server {
    listener: TcpListener,
    port: u16,
}

impl Server {
    /// Begins to listen at a port, or at any that is free for 0.
    ///
    /// # Errors
    /// A port that is taken or forbidden.
    pub fn new(port: u16) -> Result<Self, Fault> {
        let listen = || {
            let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
            listener.set_nonblocking(true)?;
            let port = listener.local_addr()?.port();
            Ok(Self { listener, port })
        };
        listen().map_err(|error: io::Error| Fault::Port(port, error.to_string()))
    }

    /// Answers the address of the page.
    pub fn address(&self) -> String {
        format!("http://{}:{}/", Ipv4Addr::LOCALHOST, self.port)
    }

    /// Answers requests as long as the program runs, on one thread: browsers keep connections open that they ask
    /// nothing on, and none of these keeps another waiting.
    ///
    /// # Errors
    /// What keeps the system from telling of connections.
    pub fn run(self, site: Site) -> Result<Infallible, Fault> {
        let port = self.port;
        let runtime = tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build();
        let served = runtime.and_then(|runtime| runtime.block_on(self.accept(Arc::new(site))));
        served.map_err(|error| Fault::Port(port, error.to_string()))
    }

    async fn accept(self, site: Arc<Site>) -> io::Result<Infallible> {
        let listener = tokio::net::TcpListener::from_std(self.listener)?;
        loop {
            let Ok((stream, _)) = listener.accept().await else {
                // It has gone away, or there are too many: those that are open go on, and some of them end.
                tokio::time::sleep(PAUSE).await;
                continue;
            };
            let site = Arc::clone(&site);
            let answer = service_fn(move |request: Request<Incoming>| {
                ready(Ok::<_, Infallible>(answer(&site, request.method(), request.uri().path())))
            });
            // A browser that has gone away needs no answer: nobody waits for the outcome.
            let connection =
                http1::Builder::new().title_case_headers(true).serve_connection(TokioIo::new(stream), answer);
            tokio::spawn(connection);
        }
    }
}

/// Answers a request; what HEAD asks for is sent without what it holds.
fn answer(site: &Site, method: &Method, address: &str) -> Response<Full<Bytes>> {
    let refused = |status, why: &'static str| response(status, "text/plain; charset=utf-8", Bytes::from(why));
    let found = |file: &File| response(StatusCode::OK, file.kind, Bytes::from(file.bytes.clone()));
    match *method {
        Method::GET | Method::HEAD => {
            site.find(address).map_or_else(|| refused(StatusCode::NOT_FOUND, "There is no such file."), found)
        }
        _ => refused(StatusCode::METHOD_NOT_ALLOWED, "Ask by GET."),
    }
}

/// Says what a response holds, that it means just that, and that it may be another one tomorrow.
fn response(status: StatusCode, kind: &'static str, bytes: Bytes) -> Response<Full<Bytes>> {
    let mut response = Response::new(Full::new(bytes));
    *response.status_mut() = status;
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    headers.insert(X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    response
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read, Write};
    use std::net::TcpStream;

    /// Answers the port of a server that serves until the test's program ends.
    fn served() -> u16 {
        let core = tempfile::NamedTempFile::new().unwrap();
        let site = Site::gather(core.path()).unwrap();
        let server = Server::new(0).unwrap();
        let port = server.port;
        std::thread::spawn(move || server.run(site));
        port
    }

    /// Asks a server and answers all that it says.
    fn asked(port: u16, line: &str) -> String {
        let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port)).unwrap();
        write!(stream, "{line} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n").unwrap();
        let mut said = String::new();
        stream.read_to_string(&mut said).unwrap();
        said
    }

    #[test]
    fn files_are_handed_out_with_their_kind_and_nothing_else_is() {
        let port = served();
        assert!(matches!(Server::new(port), Err(Fault::Port(taken, _)) if taken == port));
        let page = asked(port, "GET /");
        assert!(page.starts_with("HTTP/1.1 200 ") && page.contains("<title>scanray playground"), "{page}");
        assert!(page.contains("Content-Type: text/html"), "{page}");
        let head = asked(port, "HEAD /main.js");
        assert!(head.contains("text/javascript") && head.ends_with("\r\n\r\n"), "{head}");
        assert!(asked(port, "GET /../../Cargo.toml").starts_with("HTTP/1.1 404 "));
        assert!(asked(port, "POST /").starts_with("HTTP/1.1 405 "));
    }

    #[test]
    fn connections_that_a_browser_keeps_open_keep_no_other_waiting() {
        let port = served();
        for round in 0..8 {
            // All are open before the first is answered, and until the last is.
            let open = |_| TcpStream::connect((Ipv4Addr::LOCALHOST, port)).unwrap();
            let kept: Vec<TcpStream> = (0..12).map(open).collect();
            for (place, mut stream) in kept.iter().enumerate() {
                stream.set_read_timeout(Some(Duration::from_secs(10))).unwrap();
                write!(stream, "GET /icon.svg HTTP/1.1\r\nHost: x\r\n\r\n").unwrap();
                let mut said = [0; 15];
                let read = stream.read_exact(&mut said);
                assert!(read.is_ok() && said == *b"HTTP/1.1 200 OK", "round {round}, {place}: {read:?}");
            }
        }
    }
}
