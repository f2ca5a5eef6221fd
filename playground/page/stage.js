/** The stage: the panel's pixels, each a whole number of the screen's, and the mark on one of them. */

export class Stage {
  constructor(canvas, mark, zoom) {
    Object.assign(this, { canvas, mark, zoom, size: [canvas.width, canvas.height], at: null });
    this.context = canvas.getContext('2d', { alpha: false });
    new ResizeObserver(() => this.fit()).observe(canvas.closest('.room'));
    zoom.addEventListener('change', () => this.fit());
  }

  /** Shows pixels of a picture; it may be coarser than the panel, whose pixels it then fills in blocks. */
  show(pixels, [columns, rows], size) {
    this.size = size;
    Object.assign(this.canvas, { width: columns, height: rows });
    this.context.putImageData(new ImageData(pixels, columns, rows), 0, 0);
    this.fit();
  }

  /** Makes the panel as large as was chosen, or as fits. */
  fit() {
    const [columns, rows] = this.size;
    const ratio = devicePixelRatio;
    const border = 2 * parseFloat(getComputedStyle(this.canvas.closest('.bezel')).paddingLeft);
    const room = this.canvas.closest('.room').clientWidth - border;
    const fits = Math.floor(Math.min(room / columns, (0.72 * innerHeight) / rows) * ratio);
    const times = Number(this.zoom.value) * Math.round(ratio) || Math.max(fits, 1);
    // A pixel of the panel is a whole number of the screen's: none is wider than its neighbour.
    this.scale = times / ratio;
    this.canvas.style.width = `${columns * this.scale}px`;
    this.canvas.style.height = `${rows * this.scale}px`;
    this.place();
  }

  /** Answers the pixel under a pointer. */
  pixelAt({ offsetX, offsetY }) {
    const inside = (place, count) => Math.min(Math.max(Math.floor(place / this.scale), 0), count - 1);
    return [inside(offsetX, this.size[0]), inside(offsetY, this.size[1])];
  }

  /** Puts the mark on a pixel, or takes it away. */
  point(at) {
    this.at = at;
    this.place();
  }

  place() {
    this.mark.hidden = !this.at;
    if (!this.at) return;
    const side = Math.max(this.scale, 3);
    const [left, top] = this.at.map((n) => (n + 0.5) * this.scale - side / 2);
    Object.assign(this.mark.style, {
      left: `${left}px`,
      top: `${top}px`,
      width: `${side}px`,
      height: `${side}px`,
    });
  }

  /** Answers the picture as a PNG file. */
  png() {
    return new Promise((resolve) => this.canvas.toBlob(resolve, 'image/png'));
  }
}
