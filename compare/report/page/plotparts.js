// SPDX-License-Identifier: MIT
// Parts of all plots: colours of the page, logarithmic axes, and drawings that Chart.js does not have.
const PlotParts = (() => {
  const {el, isNumber} = Format;

  function applyTheme() {
    Chart.defaults.animation = false;
    Chart.defaults.responsive = true;
    Chart.defaults.maintainAspectRatio = false;
    Chart.defaults.color = Data.css('--ink');
    Chart.defaults.borderColor = Data.css('--line');
    Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
    Chart.defaults.font.size = 12;
  }

  // Axes end at a 1, 2 or 5 of a decade.
  function niceBelow(x) {
    const decade = 10 ** Math.floor(Math.log10(x));
    return [5, 2, 1].map((k) => k * decade).find((v) => v <= x * (1 + 1e-9)) ?? decade;
  }
  function niceAbove(x) {
    const decade = 10 ** Math.floor(Math.log10(x));
    return [1, 2, 5, 10].map((k) => k * decade).find((v) => v >= x * (1 - 1e-9));
  }

  const leadsOf = (span) => (span < 99 ? [1, 2, 5] : span < 3000 ? [1, 3] : [1]);

  // In pixels: a plot that is narrower has names for decades only, and a name needs so much room.
  const narrow = 420, nameWidth = 50;
  /** The labels of an axis of times: each k times each `every`th power of ten. */
  function leadsAcross(scale) {
    const decades = Math.log10(scale.max / scale.min), perDecade = (scale.chart.width - 70) / decades;
    const every = Math.max(1, Math.ceil(nameWidth / perDecade));
    // One decade alone does not show the length of the axis.
    const isTwo = Math.floor(Math.log10(scale.max) + 1e-9) > Math.ceil(Math.log10(scale.min) - 1e-9);
    if (scale.chart.width < narrow && isTwo) return {leads: [1], every};
    if (perDecade * Math.log10(2) > nameWidth) return {leads: [1, 2, 5], every};
    return {leads: perDecade * Math.log10(3) > nameWidth ? [1, 3] : [1], every};
  }

  /** Labels the decades, and more where there is room; the floor gets a name of its own. */
  function logAxis(title, min, max, label, {floorLabel = null, isAcross = false} = {}) {
    const isLabelled = (v, {leads, every}) => leads.some((k) => {
      const n = Math.floor(Math.log10(v / k) + 1e-9);
      return n % every === 0 && Math.abs(v / (k * 10 ** n) - 1) < 1e-6;
    });
    return {
      type: 'logarithmic',
      min,
      max,
      title: {display: Boolean(title), text: title},
      grid: {drawTicks: true},
      ticks: {
        autoSkip: false,
        maxRotation: 0,
        callback(v) {
          if (floorLabel && Math.abs(v / min - 1) < 1e-6) return floorLabel;
          const labelled = isAcross ? leadsAcross(this) : {leads: leadsOf(max / min), every: 1};
          return v >= min * (1 - 1e-9) && isLabelled(v, labelled) ? label(v) : null;
        },
      },
    };
  }

  /** The mark of an engine, as the points of a dataset. */
  function pointMark(engine) {
    const {mark} = Data.rowOf(engine);
    return {pointStyle: mark};
  }

  /** The floor stands for zero, which a logarithmic axis does not have. */
  const floorLine = {
    id: 'floorLine',
    beforeDatasetsDraw(chart, _args, options) {
      if (!isNumber(options.y)) return;
      const {ctx, chartArea: {left, right}} = chart;
      const y = chart.scales.y.getPixelForValue(options.y);
      ctx.save();
      ctx.strokeStyle = Data.css('--muted');
      ctx.setLineDash([2, 3]);
      ctx.beginPath();
      ctx.moveTo(left, y);
      ctx.lineTo(right, y);
      ctx.stroke();
      ctx.restore();
    },
  };

  /** The time of the exact reference, which is no point among the engines. */
  const exactLine = {
    id: 'exactLine',
    beforeDatasetsDraw(chart, _args, options) {
      if (!isNumber(options.x)) return;
      const {ctx, chartArea: {left, right, top, bottom}} = chart;
      const x = Math.round(chart.scales.x.getPixelForValue(options.x));
      ctx.save();
      ctx.strokeStyle = ctx.fillStyle = Data.css('--exact');
      ctx.lineWidth = 2;
      ctx.setLineDash([7, 4]);
      ctx.beginPath();
      ctx.moveTo(x, top);
      ctx.lineTo(x, bottom);
      ctx.stroke();
      if (options.isNamed) {
        ctx.font = `600 12px ${Chart.defaults.font.family}`;
        ctx.textBaseline = 'top';
        const isLeft = x + 6 + ctx.measureText('exact').width > right && x - left > right - x;
        ctx.textAlign = isLeft ? 'right' : 'left';
        ctx.fillText('exact', x + (isLeft ? -6 : 6), top + 3);
      }
      ctx.restore();
    },
  };

  /** 95% intervals: a point may carry xs and ys, each [low, high]. */
  const intervals = {
    id: 'intervals',
    beforeDatasetsDraw(chart) {
      const {ctx, chartArea, scales: {x, y}} = chart;
      ctx.save();
      ctx.beginPath();
      ctx.rect(chartArea.left, chartArea.top, chartArea.width, chartArea.height + 1);
      ctx.clip();
      ctx.lineWidth = 1;
      ctx.globalAlpha = 0.4;
      for (const dataset of chart.data.datasets) {
        ctx.strokeStyle = dataset.borderColor;
        ctx.beginPath();
        for (const point of dataset.data) {
          const px = x.getPixelForValue(point.x), py = y.getPixelForValue(point.y);
          if (point.xs) {
            ctx.moveTo(x.getPixelForValue(point.xs[0]), py);
            ctx.lineTo(x.getPixelForValue(point.xs[1]), py);
          }
          if (point.ys) {
            ctx.moveTo(px, y.getPixelForValue(Math.max(point.ys[0], y.min)));
            ctx.lineTo(px, y.getPixelForValue(Math.max(point.ys[1], y.min)));
          }
        }
        ctx.stroke();
      }
      ctx.restore();
    },
  };

  const overlaps = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

  /** Names of points beside them, where there is room; what stays without has its tooltip. */
  const pointNames = {
    id: 'pointNames',
    afterDatasetsDraw(chart) {
      const {ctx, chartArea: area} = chart;
      const taken = [];
      const points = chart.data.datasets.flatMap(
          (dataset, d) => chart.getDatasetMeta(d).data.map(
              (element, i) => ({element, point: dataset.data[i], colour: dataset.borderColor})));
      for (const {element} of points)
        taken.push([element.x - 4, element.y - 4, element.x + 4, element.y + 4]);
      ctx.save();
      ctx.font = `12px ${Chart.defaults.font.family}`;
      ctx.textBaseline = 'middle';
      for (const {element, point, colour} of points.filter((p) => p.point.name)) {
        const width = ctx.measureText(point.name).width;
        const spots = [[7, -9], [7, 10], [-width - 7, -9], [-width - 7, 10]].map(
            ([dx, dy]) => [element.x + dx, element.y + dy]);
        const boxOf = ([bx, by]) => [bx - 1, by - 6, bx + width + 1, by + 6];
        const isFree = (box) => box[0] >= area.left && box[2] <= area.right && box[1] >= area.top &&
                                box[3] <= area.bottom && !taken.some((other) => overlaps(box, other));
        const spot = spots.find((s) => isFree(boxOf(s)));
        if (!spot) continue;
        taken.push(boxOf(spot));
        ctx.fillStyle = colour;
        ctx.fillText(point.name, spot[0], spot[1]);
      }
      ctx.restore();
    },
  };

  const canvas = (label) => el('canvas', {role: 'img', 'aria-label': label});
  const frame = (child, isLow) => el('div', {class: isLow ? 'plot low' : 'plot'}, child);
  const nothing = (text) => el('p', {class: 'note'}, text);

  // Charts by their canvas, so that one that is drawn again or left behind is freed.
  const charts = new Map();
  function draw(canvas, config) {
    charts.get(canvas)?.destroy();
    for (const [old, chart] of charts) {
      if (old.isConnected) continue;
      chart.destroy();
      charts.delete(old);
    }
    charts.set(canvas, new Chart(canvas, config));
  }

  return {
    applyTheme,
    niceBelow,
    niceAbove,
    logAxis,
    pointMark,
    floorLine,
    exactLine,
    intervals,
    pointNames,
    canvas,
    frame,
    nothing,
    draw
  };
})();
