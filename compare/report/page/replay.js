// SPDX-License-Identifier: MIT
// Plays what each engine and the exact reference make of the same start, at once.
const Replay = (() => {
  const {el, isNumber} = Format;
  const speeds = [[1 / 16, '1/16'], [1 / 8, '1/8'], [1 / 4, '1/4'], [1 / 2, '1/2'], [1, '1'], [2, '2']];
  const worstPrefix = 'worst ', framesAround = 6;

  class Player {
    #scene;
    #clip;
    #frame = 0;
    #isPlaying = false;
    #speed = 1 / 4;
    #lastTime = 0;
    #hidden = new Set();
    #camera = new Camera();
    #section;
    #canvas;
    #parts = {};
    #loop = null; // the frames that are played over and over, around the worst contact

    /** Begins with the worst contact of an engine, and plays it while it can be seen. */
    constructor(scene, engine) {
      this.#scene = scene;
      this.#section = this.#build();
      new ResizeObserver(() => this.#resize()).observe(this.#canvas);
      const worst = scene.clips.find((clip) => clip.name === worstPrefix + engine);
      this.#selectClip((worst ?? scene.clips[0]).name);
      if (worst && !matchMedia('(prefers-reduced-motion: reduce)').matches) this.#playWhenSeen();
    }
    get element() { return this.#section; }

    // Requests ----------------------------------------------------------------------------------------

    #selectClip(name) {
      this.#clip = this.#scene.clips.find((clip) => clip.name === name) ?? this.#scene.clips[0];
      this.#parts.clip.value = this.#clip.name;
      this.#parts.scrub.max = this.#lastFrame;
      this.#parts.what.textContent = [this.#clip.title, this.#clip.what].filter(Boolean).join(': ');
      this.#pause();
      this.#loop = null;
      this.#fit();
      this.#goTo(0);
      if (this.#clip.contact > 0) this.#showContact();
    }
    #playWhenSeen() {
      const observer = new IntersectionObserver(([entry]) => {
        if (!entry.isIntersecting) return;
        observer.disconnect();
        this.#goTo(this.#loop[0]);
        this.#play();
      }, {threshold: 0.5});
      observer.observe(this.#canvas);
    }
    #showContact() {
      const clip = this.#clip;
      this.#loop =
          [Math.max(0, clip.contact - framesAround), Math.min(this.#lastFrame, clip.contact + framesAround)];
      this.#setSpeed(1 / 16);
      this.#goTo(clip.contact);
      this.#focus();
      this.draw();
    }
    #focus() {
      const clip = this.#clip;
      const place = this.#exactPlace(clip.contact), before = this.#exactPlace(Math.max(0, clip.contact - 1));
      const travel = Math.hypot(place[0] - before[0], place[1] - before[1]);
      if (isNumber(travel))
        this.#camera.focus(place, Math.max(12 * this.#scene.radii[clip.ball], 4 * travel));
    }
    #goTo(frame) {
      this.#frame = Math.max(0, Math.min(frame, this.#lastFrame));
      this.draw();
    }
    #stepFrame(direction) {
      this.#pause();
      this.#goTo(direction > 0 ? Math.floor(this.#frame) + 1 : Math.ceil(this.#frame) - 1);
    }
    #zoom(factor, px, py) {
      this.#camera.zoom(factor, px, py);
      this.draw();
    }
    #fit() { this.#camera.fit(Drawing.boxOf(this.#scene, this.#clip)); }
    #setSpeed(speed) {
      this.#speed = speed;
      this.#parts.speed.value = String(speed);
    }
    #toggle() {
      if (this.#isPlaying)
        this.#pause();
      else
        this.#play();
    }
    #play() {
      if (this.#frame >= this.#lastFrame) this.#frame = 0;
      this.#isPlaying = true;
      this.#lastTime = performance.now();
      this.#showPlaying();
      requestAnimationFrame((now) => this.#tick(now));
    }
    #pause() {
      this.#isPlaying = false;
      this.#showPlaying();
    }
    #tick(now) {
      if (!this.#isPlaying || !this.#section.isConnected) return;
      // A page that was in the background does not jump.
      const seconds = Math.min(Math.max(0, now - this.#lastTime) / 1000, 0.1);
      this.#lastTime = now;
      const next = this.#frame + seconds * this.#speed / this.#scene.time_step;
      const end = this.#loop && this.#frame < this.#loop[1] ? this.#loop[1] : this.#lastFrame;
      this.#goTo(next >= end && this.#loop ? this.#loop[0] : next);
      if (this.#frame >= this.#lastFrame)
        this.#pause();
      else
        requestAnimationFrame((time) => this.#tick(time));
    }

    // State ------------------------------------------------------------------------------------------

    get #shownFrame() { return Math.floor(this.#frame + 1e-9); }
    get #isContact() { return this.#clip.contact > 0 && this.#shownFrame === this.#clip.contact; }
    get #lastFrame() { return Math.max(0, this.#clip.frames - 1); }
    /** Of the ball in question, on the last track, which is the exact one. */
    #exactPlace(frame) {
      const ball = this.#clip.ball ?? 0;
      return Drawing.placeAt(this.#clip.tracks[this.#clip.tracks.length - 1], this.#scene.radii.length, ball,
                             frame);
    }

    // The picture -------------------------------------------------------------------------------------

    #resize() {
      const {clientWidth: width, clientHeight: height} = this.#canvas;
      if (width === 0 || height === 0) return;
      const ratio = window.devicePixelRatio || 1, isFirst = !('ready' in this.#section.dataset);
      this.#canvas.width = Math.round(width * ratio);
      this.#canvas.height = Math.round(height * ratio);
      this.#camera.resize(width, height);
      this.#section.dataset.ready = '';
      if (isFirst) {
        this.#fit();
        if (this.#loop) this.#focus();
      }
      this.draw();
    }

    draw() {
      const ctx = this.#canvas.getContext('2d'), ratio = window.devicePixelRatio || 1, scene = this.#scene,
            clip = this.#clip;
      ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
      ctx.fillStyle = Data.css('--surface');
      ctx.fillRect(0, 0, this.#camera.width, this.#camera.height);
      Drawing.drawShapes(ctx, this.#camera, scene.shapes, clip.orientations, clip.offsets, this.#frame);
      const longest =
          Math.hypot(scene.bounds.right - scene.bounds.left, scene.bounds.top - scene.bounds.bottom) / 4;
      const order = clip.tracks.map((_, i) => i).reverse(); // the exact one below
      for (const i of order) {
        const name = Data.tracks[i];
        if (this.#hidden.has(name)) continue;
        Drawing.drawTrack(ctx, this.#camera, name, clip.tracks[i], scene.radii, this.#frame, clip.ball,
                          longest);
      }
      if (this.#isContact)
        Drawing.drawRing(ctx, this.#camera, this.#exactPlace(clip.contact), scene.radii[clip.ball ?? 0]);
      this.#drawScale(ctx);
      this.#showState();
    }

    #drawScale(ctx) {
      const wanted = 90 / this.#camera.scale;
      const length = PlotParts.niceBelow(wanted), pixels = length * this.#camera.scale,
            y = this.#camera.height - 14;
      ctx.strokeStyle = ctx.fillStyle = Data.css('--muted');
      ctx.lineWidth = 1.5;
      ctx.beginPath();
      ctx.moveTo(14, y - 4);
      ctx.lineTo(14, y);
      ctx.lineTo(14 + pixels, y);
      ctx.lineTo(14 + pixels, y - 4);
      ctx.stroke();
      ctx.font = `12px ${getComputedStyle(document.body).fontFamily}`;
      ctx.fillText(`${Format.plain(length)} unit${length === 1 ? '' : 's'}`, 18, y - 5);
    }

    #showState() {
      const frame = this.#shownFrame, state = this.#section.dataset;
      const [x, y] = this.#camera.toPicture(this.#exactPlace(this.#frame));
      state.frame = frame;
      state.clip = this.#clip.name;
      state.ballX = isNumber(x) ? x.toFixed(1) : '';
      state.ballY = isNumber(y) ? y.toFixed(1) : '';
      this.#parts.scrub.value = this.#frame;
      this.#parts.scrub.setAttribute('aria-valuetext', `frame ${frame} of ${this.#lastFrame}`);
      this.#parts.clock.textContent = `frame ${frame} of ${this.#lastFrame}, ${
          (this.#frame * this.#scene.time_step).toFixed(3)} s${this.#isContact ? ' \u2013 the contact' : ''}`;
    }
    #showPlaying() {
      this.#parts.play.textContent = this.#isPlaying ? 'Pause' : 'Play';
      this.#section.dataset.playing = this.#isPlaying;
    }

    // The controls ------------------------------------------------------------------------------------

    #build() {
      const p = this.#parts;
      p.play = el('button', {type: 'button', 'data-action': 'play', onclick: () => this.#toggle()}, 'Play');
      p.scrub = el('input', {
        type: 'range',
        min: 0,
        step: 'any',
        value: 0,
        'aria-label': 'Frame',
        oninput: () => {
          this.#pause();
          this.#goTo(Number(p.scrub.value));
        }
      });
      p.speed = el(
          'select', {'aria-label': 'Speed', onchange: () => this.#setSpeed(Number(p.speed.value))},
          speeds.map(([value, name]) => el('option', {value: String(value), selected: value === this.#speed},
                                           `${name}\u00d7`)));
      p.clip = el('select', {'aria-label': 'Clip', onchange: () => this.#selectClip(p.clip.value)},
                  this.#scene.clips.map((clip) => el('option', {value: clip.name}, clip.title || clip.name)));
      p.clock = el('span', {class: 'clock'});
      p.what = el('p', {class: 'what', 'aria-live': 'polite'});
      this.#canvas = el('canvas', {
        class: 'stage',
        tabindex: 0,
        role: 'application',
        'aria-roledescription': 'replay',
        'aria-label':
            'Replay of the scene. Space plays, the arrows go frame by frame, plus and minus zoom, 0 shows all.',
        title:
            'Space plays and pauses, arrows go by a frame, + and \u2212 zoom, 0 shows all; drag to move; once clicked, the wheel zooms'
      });
      this.#listen();
      return el('section',
                {class: 'replay', 'aria-label': 'Replay', onkeydown: (event) => this.#onKey(event)}, p.what,
                this.#canvas, el('div', {class: 'controls'}, p.play, p.scrub, p.clock),
                el('div', {class: 'controls'}, el('label', null, 'Show ', p.clip),
                   el('label', null, 'Speed ', p.speed), this.#zoomButtons()),
                el('div', {class: 'controls'}, Data.tracks.map((name) => this.#trackToggle(name))));
    }
    #zoomButtons() {
      const button = (name, label, onclick) =>
          el('button', {type: 'button', 'aria-label': label, title: label, onclick}, name);
      return [
        button('+', 'Zoom in', () => this.#zoom(1.5)),
        button('\u2212', 'Zoom out', () => this.#zoom(1 / 1.5)),
        button('All', 'Show all',
               () => {
                 this.#fit();
                 this.draw();
               })
      ];
    }
    #trackToggle(name) {
      const box = el('input', {
        type: 'checkbox',
        checked: true,
        'data-track': name,
        onchange: () => {
          if (box.checked)
            this.#hidden.delete(name);
          else
            this.#hidden.add(name);
          this.draw();
        }
      });
      return el('label', {'--engine': `var(--${name})`}, box,
                el('span', {class: 'line', '--dashes': Drawing.dashesOf(name)}), Data.tag(name));
    }

    #listen() {
      const canvas = this.#canvas;
      canvas.addEventListener('pointerdown', (event) => this.#drag(event.clientX, event.clientY));
      // The picture does not catch the wheel of a reader who scrolls down the page.
      canvas.addEventListener('wheel', (event) => {
        if (document.activeElement !== canvas && !event.ctrlKey) return;
        event.preventDefault();
        this.#zoom(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
      }, {passive: false});
    }
    /** Follows the pointer, outside of the picture too, until it is released. */
    #drag(x, y) {
      const end = new AbortController(), options = {signal: end.signal};
      window.addEventListener('pointermove', (event) => {
        this.#camera.pan(event.clientX - x, event.clientY - y);
        [x, y] = [event.clientX, event.clientY];
        this.draw();
      }, options);
      for (const name of ['pointerup', 'pointercancel', 'blur'])
        window.addEventListener(name, () => end.abort(), options);
    }
    #onKey(event) {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const isControl = event.target !== this.#canvas && event.target.matches('button, select, input');
      const actions = {
        ' ': () => this.#toggle(),
        ArrowLeft: () => this.#stepFrame(-1),
        ArrowRight: () => this.#stepFrame(1),
        '+': () => this.#zoom(1.5),
        '=': () => this.#zoom(1.5),
        '-': () => this.#zoom(1 / 1.5),
        0: () => {
          this.#fit();
          this.draw();
        },
      };
      // Controls keep their own keys; the slider's arrows go by whole frames as well.
      const isSlider = event.target === this.#parts.scrub && event.key.startsWith('Arrow');
      if (!(event.key in actions) || (isControl && !isSlider && !'+-='.includes(event.key))) return;
      event.preventDefault();
      actions[event.key]();
    }
  }

  const isPlayable = (scene) =>
      Boolean(scene) && Data.list(scene.clips).length > 0 && Data.list(scene.radii).length > 0;

  /** The player of a scene, at the worst contact of an engine, or null where nothing was recorded. */
  const make = (scene, engine) =>
      (isPlayable(scene) ?
           new Player({...scene, shapes: Data.list(scene.shapes), clips: Data.clipsOf(scene)}, engine) :
           null);
  return {make};
})();
