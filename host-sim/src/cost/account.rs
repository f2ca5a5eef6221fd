/// Holds the instructions that a chip has executed for a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Account {
    /// Those of each row as it is drawn, from the top.
    pub rows: Vec<u64>,
    /// Those of each pixel traced alone, row by row; what a row takes to begin there is left out.
    pub pixels: Vec<u64>,
}
