// SPDX-License-Identifier: MIT
// From the scene to the picture and back. y is up in the scene and down in the picture.
const Camera = (() => {
  const mostZoom = 4000, leastZoom = 0.2; // of the view that shows all

  return class {
    #x = 0;
    #y = 0;
    #scale = 1;
    #fitScale = 1;
    #width = 1;
    #height = 1;

    resize(width, height) {
      this.#width = Math.max(1, width);
      this.#height = Math.max(1, height);
    }
    /** Shows the whole box { left, bottom, right, top } with a margin. */
    fit(box) {
      this.#x = (box.left + box.right) / 2;
      this.#y = (box.bottom + box.top) / 2;
      const w = Math.max(box.right - box.left, 1e-9), h = Math.max(box.top - box.bottom, 1e-9);
      this.#scale = this.#fitScale = 0.92 * Math.min(this.#width / w, this.#height / h);
    }
    /** Puts a place into the middle, `extent` of the scene fills the smaller side. */
    focus([x, y], extent) {
      this.#x = x;
      this.#y = y;
      this.#scale = Math.min(this.#width, this.#height) / extent;
    }
    /** Zooms by a factor; the place at (px, py) stays. */
    zoom(factor, px = this.#width / 2, py = this.#height / 2) {
      const scale =
          Math.min(Math.max(this.#scale * factor, leastZoom * this.#fitScale), mostZoom * this.#fitScale);
      this.#x += (px - this.#width / 2) * (1 / this.#scale - 1 / scale);
      this.#y -= (py - this.#height / 2) * (1 / this.#scale - 1 / scale);
      this.#scale = scale;
    }
    pan(dx, dy) {
      this.#x -= dx / this.#scale;
      this.#y += dy / this.#scale;
    }
    get scale() { return this.#scale; }
    get width() { return this.#width; }
    get height() { return this.#height; }
    toPicture([x, y]) {
      return [this.#width / 2 + (x - this.#x) * this.#scale, this.#height / 2 - (y - this.#y) * this.#scale];
    }
  };
})();
