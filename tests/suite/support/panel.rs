use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// Is a display that keeps what it was sent, accepts nothing but whole areas inside of it, and can fail.
pub struct Panel<C> {
    pub area: Rectangle,
    pub pixels: Vec<Option<C>>,
    /// The areas filled, and whether with one colour.
    pub fills: Vec<(Rectangle, bool)>,
    /// The fill that fails, once.
    pub fails_at: Option<usize>,
    rows_only: bool,
}

#[derive(Debug, PartialEq, Eq)]
pub struct BusFault(pub usize);

impl<C: PixelColor> Panel<C> {
    pub fn new(area: Rectangle) -> Self {
        let pixels = vec![None; (area.size.width * area.size.height) as usize];
        Self { area, pixels, fills: Vec::new(), fails_at: None, rows_only: false }
    }

    pub fn sized(width: u32, height: u32) -> Self {
        Self::new(Rectangle::new(Point::zero(), Size::new(width, height)))
    }

    /// Accepts nothing but rows from `fill_contiguous`.
    pub fn by_rows(mut self) -> Self {
        self.rows_only = true;
        self
    }

    pub fn is_full(&self) -> bool {
        self.pixels.iter().all(Option::is_some)
    }

    /// Answers how many pixels were sent.
    pub fn written(&self) -> u32 {
        self.fills.iter().map(|(area, _)| area.size.width * area.size.height).sum()
    }

    fn fill(
        &mut self,
        area: &Rectangle,
        colors: impl IntoIterator<Item = C>,
        solid: bool,
    ) -> Result<(), BusFault> {
        if self.fails_at == Some(self.fills.len()) {
            self.fails_at = None;
            return Err(BusFault(self.fills.len()));
        }
        assert!(!self.rows_only || area.size.height == 1 && !solid, "not a row");
        assert!(!area.is_zero_sized() && area.intersection(&self.area) == *area, "{area:?}");
        self.fills.push((*area, solid));
        let mut colors = colors.into_iter();
        for point in area.points() {
            let place = point - self.area.top_left;
            let place = place.y as usize * self.area.size.width as usize + place.x as usize;
            self.pixels[place] = Some(colors.next().expect("a colour for each pixel"));
        }
        assert!(solid || colors.next().is_none(), "more colours than pixels");
        Ok(())
    }
}

impl<C> Dimensions for Panel<C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor> DrawTarget for Panel<C> {
    type Color = C;
    type Error = BusFault;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, _: I) -> Result<(), BusFault> {
        panic!("pixels were drawn one by one");
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), BusFault> {
        self.fill(area, colors, false)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), BusFault> {
        self.fill(area, std::iter::repeat(color), true)
    }
}
