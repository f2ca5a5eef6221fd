//! The server: hands the playground to browsers of this computer.

use super::site::File;
use super::{Fault, Site};
use std::io::Cursor;
use std::net::Ipv4Addr;
use tiny_http::{Header, Method, Response};

/// Listens on the loopback address: no other computer can ask.
pub struct Server {
    http: tiny_http::Server,
    port: u16,
}

impl Server {
    /// Begins to listen at a port, or at any that is free for 0.
    ///
    /// # Errors
    /// A port that is taken or forbidden.
    pub fn new(port: u16) -> Result<Self, Fault> {
        let fault = |why: String| Fault::Port(port, why);
        let http =
            tiny_http::Server::http((Ipv4Addr::LOCALHOST, port)).map_err(|error| fault(error.to_string()))?;
        let address = http.server_addr().to_ip().ok_or_else(|| fault("it has no address".to_owned()))?;
        Ok(Self { http, port: address.port() })
    }

    /// Answers the address of the page.
    pub fn address(&self) -> String {
        format!("http://{}:{}/", Ipv4Addr::LOCALHOST, self.port)
    }

    /// Answers requests as long as the program runs.
    pub fn run(&self, site: &Site) {
        for request in self.http.incoming_requests() {
            let response = match request.method() {
                Method::Get | Method::Head => site.find(request.url()).map_or_else(missing, found),
                _ => refused(405, "Ask by GET."),
            };
            // A browser that has gone away needs no answer.
            let _ = request.respond(response);
        }
    }
}

fn found(file: &File) -> Response<Cursor<Vec<u8>>> {
    with_kind(Response::from_data(file.bytes.clone()), file.kind)
}

fn missing() -> Response<Cursor<Vec<u8>>> {
    refused(404, "There is no such file.")
}

fn refused(status: u16, why: &str) -> Response<Cursor<Vec<u8>>> {
    with_kind(Response::from_data(why).with_status_code(status), "text/plain; charset=utf-8")
}

/// Says what a response holds, that it means just that, and that it may be another one tomorrow.
fn with_kind(response: Response<Cursor<Vec<u8>>>, kind: &str) -> Response<Cursor<Vec<u8>>> {
    let headers =
        [("Content-Type", kind), ("X-Content-Type-Options", "nosniff"), ("Cache-Control", "no-cache")];
    // These are ASCII, as headers have to be.
    let headers = headers.into_iter().filter_map(|(name, value)| Header::from_bytes(name, value).ok());
    headers.fold(response, Response::with_header)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read, Write};
    use std::net::TcpStream;

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
        let core = tempfile::NamedTempFile::new().unwrap();
        let site = Site::gather(core.path()).unwrap();
        let server = Server::new(0).unwrap();
        let port = server.port;
        assert!(matches!(Server::new(port), Err(Fault::Port(taken, _)) if taken == port));
        // It serves until the test's program ends.
        std::thread::spawn(move || server.run(&site));
        let page = asked(port, "GET /");
        assert!(page.starts_with("HTTP/1.1 200 ") && page.contains("<title>scanray playground"), "{page}");
        assert!(page.contains("Content-Type: text/html"), "{page}");
        let head = asked(port, "HEAD /main.js");
        assert!(head.contains("text/javascript") && head.ends_with("\r\n\r\n"), "{head}");
        assert!(asked(port, "GET /../../Cargo.toml").starts_with("HTTP/1.1 404 "));
        assert!(asked(port, "POST /").starts_with("HTTP/1.1 405 "));
    }
}
