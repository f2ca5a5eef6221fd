//! The way of rows to a panel.

/// Takes full buffers to the panel, one after the other.
pub trait Wire<B>: Sized {
    /// Queues `full` behind the row that is being sent, waits until that one is out and answers its buffer.
    ///
    /// The first buffer of a frame finds nothing before it: then a spare one is answered at once.
    fn exchange(self, full: B) -> (Self, B);
}
