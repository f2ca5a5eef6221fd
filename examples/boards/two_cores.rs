//! Two cores draw one picture: rows are dealt out in turn, and nobody waits inside a row.
//!
//! The first core traces the even rows and sends all of them; the second traces the odd ones. Buffers go
//! round between them through two queues of one writer and one reader each, which take no lock and no
//! atomic swap (the M0+ has none): empty ones to the second core, full ones back. A buffer belongs to one
//! core at a time, and its row is known by its place in the queue, so no row is lost or drawn twice.
//!
//! Neighbouring rows cost nearly the same, so taking turns is fair. Where they differ, the second core
//! runs ahead by as many rows as there are buffers.

use heapless::spsc::{Consumer, Producer, Queue};

use super::wire::Wire;

/// Counts the buffers that go round between the cores.
pub const BUFFERS: usize = 4;

/// Holds the buffers on their way between the cores.
pub struct Mailboxes<B> {
    // A queue of N places holds N - 1.
    empty: Queue<B, { BUFFERS + 1 }>,
    full: Queue<B, { BUFFERS + 1 }>,
}

/// Is the first core's end of the mailboxes.
pub struct First<'q, B> {
    empty: Producer<'q, B>,
    full: Consumer<'q, B>,
}

/// Is the second core's end of the mailboxes.
pub struct Second<'q, B> {
    empty: Consumer<'q, B>,
    full: Producer<'q, B>,
}

impl<B> Mailboxes<B> {
    /// Makes mailboxes in which all of `buffers` wait for the second core.
    pub fn new(buffers: [B; BUFFERS]) -> Self {
        let mut mailboxes = Self { empty: Queue::new(), full: Queue::new() };
        let (first, _) = mailboxes.ends();
        let mut empty = first.empty;
        buffers.into_iter().for_each(|buffer| post(&mut empty, buffer));
        mailboxes
    }

    /// Answers each core's end.
    pub fn ends(&mut self) -> (First<'_, B>, Second<'_, B>) {
        let (to_second, from_first) = self.empty.split();
        let (to_first, from_second) = self.full.split();
        (First { empty: to_second, full: from_second }, Second { empty: from_first, full: to_first })
    }
}

impl<B> First<'_, B> {
    /// Draws rows 0 to `rows` - 1 with the second core's help, which draws the same picture.
    ///
    /// Answers the wire with the last row still on its way, and the buffer that is free.
    pub fn draw<W: Wire<B>>(
        &mut self,
        rows: u32,
        mut wire: W,
        mut buffer: B,
        mut trace: impl FnMut(u32, &mut B),
    ) -> (W, B) {
        for y in 0..rows {
            if y % 2 == 0 {
                trace(y, &mut buffer);
                (wire, buffer) = wire.exchange(buffer);
            } else {
                let (next, empty) = wire.exchange(wait(|| self.full.dequeue()));
                wire = next;
                post(&mut self.empty, empty);
            }
        }
        (wire, buffer)
    }
}

impl<B> Second<'_, B> {
    /// Traces the odd rows below `rows`.
    pub fn draw(&mut self, rows: u32, mut trace: impl FnMut(u32, &mut B)) {
        for y in (1..rows).step_by(2) {
            let mut buffer = wait(|| self.empty.dequeue());
            trace(y, &mut buffer);
            post(&mut self.full, buffer);
        }
    }
}

/// Asks again and again until there is an answer: the other core needs microseconds, not a scheduler.
fn wait<T>(mut ask: impl FnMut() -> Option<T>) -> T {
    loop {
        match ask() {
            Some(answer) => return answer,
            None => core::hint::spin_loop(),
        }
    }
}

/// Puts a buffer into a queue. There are no more buffers than places: a refusal would lose a row.
fn post<B>(queue: &mut Producer<'_, B>, buffer: B) {
    assert!(queue.enqueue(buffer).is_ok(), "more buffers than places");
}
