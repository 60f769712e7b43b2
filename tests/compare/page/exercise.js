// SPDX-License-Identifier: MIT
// After everything else on the page: does what a reader does, looks at what is then to be seen, and leaves it
// as JSON.
(async () => {
  const $ = (selector, root = document) => root.querySelector(selector);
  const $$ = (selector, root = document) => [...root.querySelectorAll(selector)];
  const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  // A page with broken data has none.
  const engines = (() => {
    try {
      return [...JSON.parse($('#run').textContent).engines.map((row) => row.name), 'exact'];
    } catch {
      return ['exact'];
    }
  })();

  async function until(condition, what) {
    for (let i = 0; i < 1000; ++i) {
      if (condition()) return;
      await wait(20);
    }
    throw new Error(`waited in vain for ${what}`);
  }

  // Any colour of CSS as [red, green, blue, alpha] from 0 to 255.
  const probe = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  function rgba(colour) {
    probe.clearRect(0, 0, 1, 1);
    probe.fillStyle = colour;
    probe.fillRect(0, 0, 1, 1);
    return [...probe.getImageData(0, 0, 1, 1).data];
  }

  /** Pixels in exactly the colour of each engine, and how many colours there are; of a part of the canvas. */
  function look(canvas, part = [0, 0, 1, 1]) {
    const {width, height} = canvas;
    const [x, y, w, h] =
        [part[0] * width, part[1] * height, part[2] * width, part[3] * height].map(Math.round);
    const data = new Uint32Array(canvas.getContext('2d').getImageData(x, y, w, h).data.buffer);
    const counts = new Map();
    for (const pixel of data)
      counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
    const of = (name) =>
        counts.get(new Uint32Array(new Uint8ClampedArray(rgba(css(`--${name}`))).buffer)[0]) ?? 0;
    const names = [...engines, 'heat'];
    return {colours: counts.size, ...Object.fromEntries(names.map((name) => [name, of(name)]))};
  }
  /** The least room between two names of the time axis, in pixels, and how many there are. */
  function axesOf(canvas) {
    const chart = Chart.getChart(canvas), {x} = chart.scales;
    chart.ctx.font = x._resolveTickFontOptions(0).string;
    const names =
        x.ticks.map((tick, i) => ({at: x.getPixelForTick(i), text: tick.label})).filter((t) => t.text);
    const ends = names.map(({at, text}) => {
      const half = chart.ctx.measureText(text).width / 2;
      return [at - half, at + half];
    });
    ends.sort((a, b) => a[0] - b[0]);
    const room = Math.min(1e3, ...ends.slice(1).map((end, i) => end[0] - ends[i][1]));
    return {room, names: names.length};
  }
  const workAxes = () => $$('canvas[data-plot=error], canvas[data-plot=tunneled]').map(axesOf);
  const textOf = (selector) => $$(selector).map((e) => e.textContent);
  const picture = (canvas) => canvas.toDataURL();

  // Contrast as WCAG 2 defines it.
  function luminance(colour) {
    const [r, g, b] = colour.slice(0, 3)
                          .map((c) => c / 255)
                          .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  }
  function contrast(a, b) {
    const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  }
  function backgroundOf(element) {
    for (let e = element; e; e = e.parentElement) {
      const colour = rgba(getComputedStyle(e).backgroundColor);
      if (colour[3] === 255) return colour;
    }
    return [255, 255, 255, 255];
  }
  /** The text of the page that is hardest to read. */
  function worstText() {
    let worst = {contrast: 21, where: ''};
    for (const element of $$('body *')) {
      const hasText =
          [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim());
      if (!hasText || element.closest('script, noscript') || element.getClientRects().length === 0 ||
          element.matches(':disabled'))
        continue;
      const found = contrast(rgba(getComputedStyle(element).color), backgroundOf(element));
      if (found < worst.contrast)
        worst = {
          contrast: found,
          where: `${element.tagName}.${element.className} "${element.textContent.slice(0, 40)}"`
        };
    }
    return worst;
  }

  const isShown = (element) => element.checkVisibility() && !element.closest('[hidden]');

  /** Boxes of all text that is shown in some elements, as [left, top, right, bottom, text, element]. */
  function textBoxes(elements) {
    const boxes = [];
    for (const element of elements.filter(isShown)) {
      const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
      for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const clip = getComputedStyle(node.parentElement).clipPath; // of what only a screen reader reads
        if (!node.textContent.trim() || node.parentElement.closest('title') || clip.startsWith('inset'))
          continue;
        const range = document.createRange();
        range.selectNodeContents(node);
        for (const r of range.getClientRects())
          if (r.width > 0) boxes.push([r.left, r.top, r.right, r.bottom, node.textContent.trim(), node]);
      }
    }
    return boxes;
  }
  const area = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) *
                         Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
  /** Texts that lie on each other, or on a mark; lines of one text may touch. */
  function overlaps() {
    const found = [];
    const least = 8; // square pixels: a box of letters is higher than the letters
    for (const group of [$$('.tile'), $$('.matrix thead'), $$('.matrix tbody tr'), $$('svg.engines')]
             .flat()) {
      const texts = textBoxes([group]);
      const marks = $$('[data-engine]', group).filter((e) => e.ownerSVGElement && isShown(e)).map((e) => {
        const r = e.getBoundingClientRect();
        return [r.left, r.top, r.right, r.bottom, `mark of ${e.dataset.engine}`];
      });
      texts.forEach((a, i) => {
        for (const b of [...texts.slice(i + 1), ...marks])
          if (a[5] !== b[5] && area(a, b) > least) found.push(`${a[4]} | ${b[4]}`);
      });
    }
    return found;
  }
  /**
   * Elements wider than the page, outside of those that scroll by themselves, text that is cut, and rows
   * that are none.
   */
  function cut() {
    const width = document.documentElement.clientWidth;
    const name = (e) => `${e.tagName}.${e.className.baseVal ?? e.className} ${e.textContent.slice(0, 30)}`;
    const wide = $$('body *').filter((e) => isShown(e) && !e.closest('.scroll *, script, iframe') &&
                                            getComputedStyle(e).position !== 'absolute' &&
                                            e.getBoundingClientRect().right > width + 0.5);
    const boxes = textBoxes($$('.tile, .matrix td, .matrix th')).filter(([, , right, , , node]) => {
      const cell = node.parentElement.closest('.tile, td, th').getBoundingClientRect();
      return right > cell.right + 0.5;
    });
    // On a phone the answers are no table any more.
    const rows =
        $$('tr:not(.answers tr)').filter((e) => isShown(e) && getComputedStyle(e).display !== 'table-row');
    return [...wide.map(name), ...boxes.map((box) => box[4]), ...rows.map(name)];
  }
  /** Sizes of letters in pixels. */
  const letterSizes =
      () => [...new Set(textBoxes([document.body])
                            .filter((box) => !box[5].parentElement.closest('script, #test-result'))
                            .map((box) => parseFloat(getComputedStyle(box[5].parentElement).fontSize)))]
                .sort((a, b) => a - b);
  /** Sentences that are there twice. */
  function repeated() {
    const sentences = $$('main p, main li:not(.counts li), main h1, footer p')
                          .filter((e) => isShown(e) && !e.querySelector('p, li') && !e.closest('.answers'))
                          .flatMap((e) => e.textContent.split(/(?<=[.!?;])\s+/))
                          .map((text) => text.trim())
                          .filter((text) => text.split(' ').length > 6);
    return [...new Set(sentences.filter((text, i) => sentences.indexOf(text) !== i))];
  }
  const bottomOf = (selector) =>
      ($(selector) ? $(selector).getBoundingClientRect().bottom + window.scrollY : 0);

  /** Words that say that a value was not there. */
  function oddWords() {
    const attributes =
        $$('main *, footer *')
            .flatMap((e) => [e.title, e.getAttribute('aria-label'), e.getAttribute('aria-valuetext')])
            .filter(Boolean);
    const text = [$('footer').innerText, $('main').innerText, ...attributes].join('\n');
    return [...new Set(text.match(/\b(NaN|undefined|null|Infinity)\b|\[object/g) ?? [])];
  }

  const key = (element, name) =>
      element.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true, cancelable: true}));
  const frameOf = (replay) => Number(replay.dataset.frame);

  /** Pixels of the exact track at a frame. */
  function wayAt(replay, frame) {
    const slider = $('input[type=range]', replay);
    slider.value = frame;
    slider.dispatchEvent(new Event('input'));
    const seen = look($('canvas', replay)).exact;
    slider.value = 0;
    slider.dispatchEvent(new Event('input'));
    return seen;
  }

  async function playReplay(replay) {
    const play = $('[data-action=play]', replay), before = frameOf(replay);
    play.click();
    if (replay.dataset.playing !== 'true') throw new Error('the replay does not play');
    await until(() => frameOf(replay) > before + 2, 'frames to pass');
    if (replay.dataset.playing === 'true') play.click();
    const stopped = frameOf(replay);
    await wait(300);
    const {playing} = replay.dataset;
    return {before, after: stopped, isPlaying: playing, rested: frameOf(replay) === stopped};
  }

  function choose(select, value) {
    select.value = value;
    select.dispatchEvent(new Event('change'));
  }

  async function goToWorst(replay, engine) {
    const canvas = $('canvas', replay);
    choose($('[aria-label=Clip]', replay), `worst ${engine}`);
    await wait(50);
    const middle = [1 / 3, 1 / 3, 1 / 3, 1 / 3], ring = look(canvas, middle).heat;
    key(canvas, 'ArrowLeft');
    const ringBefore = look(canvas).heat;
    key(canvas, 'ArrowRight');
    return {
      ring,
      ringBefore,
      clip: replay.dataset.clip,
      frame: frameOf(replay),
      text: $('.what', replay).textContent,
      x: Number(replay.dataset.ballX) / canvas.clientWidth,
      y: Number(replay.dataset.ballY) / canvas.clientHeight,
      middle: look(canvas, middle),
    };
  }

  async function useKeys(replay) {
    const canvas = $('canvas', replay), start = frameOf(replay), seen = {};
    key(canvas, 'ArrowRight');
    seen.right = frameOf(replay) - start;
    key(canvas, 'ArrowLeft');
    key(canvas, 'ArrowLeft');
    seen.left = frameOf(replay) - start;
    key(canvas, ' ');
    seen.space = replay.dataset.playing;
    key(canvas, ' ');
    seen.spaceAgain = replay.dataset.playing;
    const moved = (act) => {
      const before = picture(canvas);
      act();
      return picture(canvas) !== before;
    };
    seen.plus = moved(() => key(canvas, '+'));
    seen.minus = moved(() => key(canvas, '-'));
    seen.all = moved(() => key(canvas, '0'));
    canvas.focus();
    seen.wheel = moved(
        () => canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, bubbles: true, cancelable: true})));
    const x = Number(replay.dataset.ballX);
    canvas.dispatchEvent(new PointerEvent('pointerdown', {clientX: 100, clientY: 100, bubbles: true}));
    window.dispatchEvent(new PointerEvent('pointermove', {clientX: 130, clientY: 100}));
    window.dispatchEvent(new PointerEvent('pointerup', {}));
    window.dispatchEvent(new PointerEvent('pointermove', {clientX: 300, clientY: 100}));
    seen.dragged = Number(replay.dataset.ballX) - x;
    const slider = $('input[type=range]', replay);
    slider.value = 5;
    slider.dispatchEvent(new Event('input'));
    seen.scrubbed = frameOf(replay);
    key(canvas, '0');
    seen.shown = look(canvas).native;
    $('[data-track=native]', replay).click();
    seen.hidden = look(canvas).native;
    $('[data-track=native]', replay).click();
    return seen;
  }

  async function unfold() {
    const folds = $$('#scene-body details');
    for (const fold of folds)
      fold.open = true;
    await until(() => folds.every((fold) => fold.lastElementChild.childElementCount > 0), 'what is folded');
    await wait(100);
    return folds;
  }

  async function visit(name) {
    choose($('#scene-select'), name);
    await until(() => $('#scene-body').dataset.scene === name, name);
    await until(() => !$('.replay') || 'ready' in $('.replay').dataset, 'the replay');
    const folds = await unfold();
    const seen = {
      name,
      folds: folds.length,
      cut: cut(),
      overlaps: overlaps(),
      repeated: repeated(),
      sizes: letterSizes(),
      chart: Boolean($('#scene-chart svg')),
      answers: textOf('table.answers tbody tr'),
      verdict: textOf('.verdict')[0],
      hash: decodeURIComponent(location.hash),
      odd: oddWords(),
      text: worstText(),
      heatMaps: $$('[data-heat]').length,
      outcomes: $$('[data-outcomes]').length,
      metrics: $$('[data-metrics] tr').length,
      bins: $$('[data-bins] tr').length,
      effects: $$('[data-effects] tbody tr').map((row) => row.textContent),
      uncalled: $$('[data-effects] .uncalled').length,
      differing: textOf('[data-effects] .differs'),
      axes: workAxes(),
      work: textOf('#scene-body').join(' '),
      settings: textOf('#scene-body details td'),
      heatNote: textOf('.heatmaps').length > 0 ? $('.heatmaps').previousElementSibling.textContent : '',
      heatCells: textOf('[data-heat] td'),
      farCells: $$('[data-heat] .far').length,
      counts: textOf('.counts li')
    };
    seen.plots = Object.fromEntries(
        $$('#scene-body canvas[data-plot]').map((canvas) => [canvas.dataset.plot, look(canvas)]));
    const replay = $('.replay');
    if (!replay) return seen;
    if (replay.dataset.playing === 'true') $('[data-action=play]', replay).click();
    seen.worstFirst = replay.dataset.clip;
    choose($('[aria-label=Clip]', replay), 'start');
    seen.replay = look($('canvas', replay));
    seen.start = wayAt(replay, 0);
    seen.end = wayAt(replay, 12);
    seen.play = await playReplay(replay);
    seen.worst = {};
    for (const option of $$('[aria-label=Clip] option', replay).filter((o) => o.value.startsWith('worst ')))
      seen.worst[option.value.slice(6)] = await goToWorst(replay, option.value.slice(6));
    seen.keys = await useKeys(replay);
    return seen;
  }

  /** Paper is white, whatever the screen is. */
  function print() {
    const plot = () => look($('canvas[data-plot=error]'))[engines[0]];
    window.dispatchEvent(new Event('beforeprint'));
    const seen = {paper: rgba(css('--bg')).slice(0, 3), plot: plot()};
    window.dispatchEvent(new Event('afterprint'));
    return {...seen, screen: rgba(css('--bg')).slice(0, 3), plotAfter: plot()};
  }

  async function followLinks(names) {
    const shown = () => $('#scene-body').dataset.scene;
    const seen = [];
    const follow = async (selector, name) => {
      $(selector).click();
      await until(() => shown() === name, `${name} by ${selector}`);
      seen.push(shown());
    };
    await follow('#matrix tbody a', names[0]);
    await follow('[aria-label="Next scene"]', names[1 % names.length]);
    await follow('[aria-label="Scene before"]', names[0]);
    $('a[href="#first"]').click();
    await wait(200);
    return [...seen, location.hash];
  }

  async function exercise(result) {
    const isReady = () => 'ready' in document.documentElement.dataset;
    await until(() => isReady() || window.noted.length > 0, 'the page');
    result.text = $('#first').innerText;
    if (!isReady()) return;
    result.isInterrupted = Boolean($('#interrupted'));
    result.rows = $$('#matrix tbody tr').length;
    result.matrix = textOf('#matrix tbody td');
    result.tiles = textOf('.tile');
    result.footer = $('footer').innerText;
    result.firstScreen = bottomOf('#overall-chart');
    result.labels = $$('#overall-chart svg').filter(isShown).map((svg) => $$('.label', svg).length);
    result.cut = cut();
    result.overlaps = overlaps();
    result.width = document.documentElement.scrollWidth - document.documentElement.clientWidth;
    result.isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    result.seriesContrast =
        Math.min(...engines.map((name) => contrast(rgba(css(`--${name}`)), rgba(css('--surface')))));
    const names = $$('#scene-select option').map((option) => option.value);
    for (const name of names)
      result.scenes.push(await visit(name));
    if (names.length > 0) {
      result.links = await followLinks(names);
      await unfold();
      result.print = print();
    }
    result.isDone = true;
  }

  // The browser hands out the page once it is loaded, which it is not before this frame is. Time is real:
  // with virtual time no frames are drawn.
  const holder = document.createElement('iframe');
  holder.hidden = true;
  document.body.append(holder);
  holder.contentDocument.open();

  const result = {errors: window.noted, scenes: [], isDone: false};
  try {
    await exercise(result);
  } catch (error) {
    window.noted.push(`exercise: ${error.message}`);
  }
  result.resources = performance.getEntriesByType('resource').map((entry) => entry.name);
  const text = document.createElement('pre');
  text.id = 'test-result';
  text.textContent = JSON.stringify(result).replace(/[<>&]/g, (c) => `\\u00${c.charCodeAt(0).toString(16)}`);
  document.body.append(text);
  holder.contentDocument.close();
})();
