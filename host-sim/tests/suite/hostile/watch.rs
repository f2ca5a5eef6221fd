//! A watch that ends the program when a scene takes too long, and says which: a test that hangs says nothing.

use std::collections::BTreeMap;
use std::sync::{Mutex, Once};
use std::thread;
use std::time::{Duration, Instant};

/// Holds the scenes at work, by name and number, with when they were begun.
static BUSY: Mutex<BTreeMap<(&str, u64), Instant>> = Mutex::new(BTreeMap::new());

static WATCHING: Once = Once::new();

fn busy(change: impl FnOnce(&mut BTreeMap<(&'static str, u64), Instant>)) {
    if let Ok(mut busy) = BUSY.lock() {
        change(&mut busy);
    }
}

/// Does something to a scene that may not take longer than this.
pub fn timed<T>(name: &'static str, number: u64, most: Duration, work: impl FnOnce() -> T) -> T {
    WATCHING.call_once(|| drop(thread::spawn(move || watch(most))));
    busy(|busy| {
        busy.insert((name, number), Instant::now());
    });
    let done = work();
    busy(|busy| {
        busy.remove(&(name, number));
    });
    done
}

fn watch(most: Duration) {
    loop {
        thread::sleep(Duration::from_secs(1));
        busy(|busy| {
            let late = busy.iter().find(|(_, begun)| begun.elapsed() > most);
            if let Some(((name, number), begun)) = late {
                eprintln!("{name}: scene {number} is not done after {:?}", begun.elapsed());
                std::process::exit(1);
            }
        });
    }
}
