use scanray::accel;
use std::collections::HashMap;

/// Is lists of things, each of them held once.
#[derive(Clone, Debug)]
pub(super) struct Lists {
    starts: Vec<u32>,
    items: Vec<u16>,
    /// The number of each list.
    known: HashMap<Vec<u16>, usize>,
}

impl Lists {
    pub fn new() -> Self {
        Self { starts: vec![0], items: vec![], known: HashMap::new() }
    }

    /// Counts the lists.
    pub fn len(&self) -> usize {
        self.known.len()
    }

    /// Answers the number of a list, which may be too large for a link where there are too many.
    pub fn number(&mut self, list: Vec<u16>) -> u16 {
        let next = self.known.len();
        let (starts, items) = (&mut self.starts, &mut self.items);
        let number = *self.known.entry(list).or_insert_with_key(|list| {
            items.extend(list);
            starts.push(items.len() as u32);
            next
        });
        number as u16
    }

    /// Answers the lists as the core has them; they live as long as the program.
    pub fn leak(&self) -> accel::Lists {
        accel::Lists::new(self.starts.clone().leak(), self.items.clone().leak())
    }

    /// Counts the bytes that they take in flash.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.starts) + size_of_val(&*self.items)
    }
}
