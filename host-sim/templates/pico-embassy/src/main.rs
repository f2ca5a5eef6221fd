//! A ray-traced picture on a Raspberry Pi Pico with an ST7789 panel, by embassy.
//!
//! A row is traced while the last is sent by DMA. `scene.rs` is what it shows, `board.rs` the wires.
#![no_std]
#![no_main]

mod board;
#[allow(dead_code, reason = "a baked scene tells its size too")]
mod scene;

use embassy_executor::Spawner;
use embassy_futures::join::join;
use embedded_graphics::geometry::Size;
use panic_halt as _;
use scanray::{Fixed, Renderer, Workspace};

use board::{HEIGHT, Panel, Trouble, WIDTH};

/// Counts the mirrors that light may meet on its way, at most; each takes 44 bytes of RAM.
const DEPTH: usize = 5;

/// Is a row of pixels, as the bus wants them.
type Row = [[u8; 2]; WIDTH as usize];

/// Traces rows into buffers of their own: the workspace needs none.
type Tracer<'w> = Renderer<'static, 'w, Fixed, [u8; 2], 0, DEPTH>;

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let (mut lamp, mut panel) = board::take().await;
    lamp.on();
    let drawn = match &mut panel {
        Ok(panel) => draw(panel).await,
        Err(trouble) => Err(*trouble),
    };
    // It never ends: a panel that is dropped would let go its pins, and its backlight would go out.
    lamp.tell(drawn).await
}

/// Traces the picture into two rows that take turns: one is on its way to the panel while the other is traced.
async fn draw(panel: &mut Panel) -> Result<(), Trouble> {
    let mut workspace = Workspace::new();
    let size = Size::new(WIDTH.into(), HEIGHT.into());
    let tracer = Renderer::new(&scene::SCENE, &scene::CAMERA, size, scene::SETTINGS, &mut workspace);
    let mut tracer: Tracer = tracer.map_err(|_| Trouble::Scene)?;
    let (mut full, mut empty): (Row, Row) = ([[0; 2]; _], [[0; 2]; _]);
    trace(&mut tracer, 0, &mut full)?;
    for y in 1..HEIGHT {
        // The bus comes first: DMA starts, and the row is on its way while tracing has the core.
        let (sent, traced) =
            join(panel.send(y - 1, full.as_flattened()), async { trace(&mut tracer, y, &mut empty) }).await;
        sent.and(traced)?;
        core::mem::swap(&mut full, &mut empty);
    }
    panel.send(HEIGHT - 1, full.as_flattened()).await
}

fn trace(tracer: &mut Tracer, y: u16, row: &mut Row) -> Result<(), Trouble> {
    tracer.render_row(y.into(), row).map_err(|_| Trouble::Scene)
}
