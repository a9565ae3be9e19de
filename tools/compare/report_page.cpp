#include "tools/compare/report_html.h"

namespace linkdig::compare {

const char* const report_page_head = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>linkdig compare</title>
<style>
  :root { color-scheme: dark; }
  body { margin: 0; background: #16191d; color: #d9dde2; font: 14px/1.45 system-ui, sans-serif;
         display: grid; grid-template: auto 1fr / 24rem 1fr; height: 100vh; }
  header { grid-column: 1 / 3; padding: .7rem 1rem; border-bottom: 1px solid #333a42; }
  header b { font-size: 1.15em; }
  header ul { margin: .3rem 0 0; padding-left: 1.2rem; color: #f0b46a; max-height: 7rem; overflow: auto; }
  nav { overflow: auto; border-right: 1px solid #333a42; }
  table { border-collapse: collapse; width: 100%; }
  th, td { padding: .25rem .5rem; text-align: right; white-space: nowrap; }
  th { position: sticky; top: 0; background: #20252b; font-weight: 600; }
  th:first-child, td:first-child { text-align: left; white-space: normal; overflow-wrap: anywhere; }
  tbody tr { cursor: pointer; }
  tbody tr:hover { background: #232a32; }
  tbody tr.chosen { background: #2b4a6b; }
  main { overflow: auto; padding: .7rem 1rem; display: flex; flex-direction: column; gap: .6rem; }
  .bar { display: flex; flex-wrap: wrap; gap: .4rem; align-items: center; }
  button { background: #2a3037; color: inherit; border: 1px solid #444d57; border-radius: 4px; padding: .25rem .6rem; cursor: pointer; }
  button.on { background: #2b4a6b; border-color: #5b8ec4; }
  kbd { font: 11px monospace; color: #98a3ae; }
  #stage { position: relative; overflow: auto; background: #0c0e10; border: 1px solid #333a42; flex: 1 1 24rem; min-height: 16rem; }
  #canvas { position: relative; display: flex; gap: 6px; }
  figure { margin: 0; position: relative; flex: none; }
  figure img { display: block; image-rendering: pixelated; }
  figcaption { position: absolute; left: 4px; top: 4px; background: #000a; padding: 0 .4rem; border-radius: 3px; font-size: 12px; }
  .over { position: absolute !important; left: 0; top: 0; }
  #divider { position: absolute; top: 0; bottom: 0; width: 2px; background: #ffd24a; pointer-events: none; }
  dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem .8rem; margin: 0; }
  dt { color: #98a3ae; } dd { margin: 0; overflow-wrap: anywhere; }
  #histogram { display: flex; align-items: flex-end; gap: 4px; height: 7rem; }
  #histogram div { flex: 1; min-width: 2.6rem; text-align: center; font-size: 11px; color: #98a3ae; }
  #histogram i { display: block; background: #d9822b; margin: 0 15%; }
</style>
</head>
<body>
<header><b id="summary"></b><ul id="messages"></ul></header>
<nav><table><thead><tr><th>frame</th><th>pixels</th><th>%</th><th>max</th><th>RMS</th></tr></thead><tbody id="rows"></tbody></table></nav>
<main>
  <div class="bar" id="views"></div>
  <div id="stage"><div id="canvas"></div></div>
  <dl id="numbers"></dl>
  <div id="histogram"></div>
</main>
)page";

const char* const report_page_script = R"page(<script>
'use strict';
// One state, drawn anew after each change.
const views = [['side', 'side by side', '1'], ['expected', 'expected', '2'], ['actual', 'actual', '3'],
               ['difference', 'difference', '4'], ['flicker', 'flicker', 'f'], ['slider', 'slider', 's']];
const state = { frame: 0, view: 'side', zoom: 1, split: 0.5, phase: 0 };
const by = id => document.getElementById(id);
const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
const short = value => value === null ? 'unbounded' : +value.toPrecision(4);
const titles = { expected: 'expected', actual: 'actual', difference: 'difference' };

function picture(which, over) {
  const frame = data.frames[state.frame];
  const image = element('img', { src: frame[which], alt: titles[which] });
  const scale = () => { image.style.width = image.naturalWidth * state.zoom + 'px'; };
  image.onload = scale;
  if (image.complete) scale();
  const label = which === 'difference' ? `difference x ${short(frame.gain)}` : titles[which];
  const figure = element('figure', { className: over ? 'over' : '' }, image, element('figcaption', { textContent: label }));
  figure.dataset.picture = which;
  return figure;
}

function drawStage() {
  const canvas = by('canvas');
  canvas.replaceChildren();
  if (!data.frames.length || !data.frames[state.frame].expected) return;
  if (state.view === 'side') canvas.append(picture('expected'), picture('actual'), picture('difference'));
  else if (state.view === 'flicker') {
    canvas.append(picture('expected'), picture('actual', true));
    canvas.lastChild.style.visibility = state.phase ? 'visible' : 'hidden';
  } else if (state.view === 'slider') {
    canvas.append(picture('expected'), picture('actual', true), element('div', { id: 'divider' }));
    drawSplit();
  } else canvas.append(picture(state.view));
}

function drawSplit() {
  const over = document.querySelector('#canvas .over');
  if (!over || state.view !== 'slider') return;
  over.style.clipPath = `inset(0 0 0 ${state.split * 100}%)`;
  const width = document.querySelector('#canvas img').getBoundingClientRect().width;
  by('divider').style.left = state.split * width + 'px';
}

function drawNumbers() {
  const numbers = by('numbers'), frame = data.frames[state.frame];
  numbers.replaceChildren();
  by('histogram').replaceChildren();
  if (!frame) return;
  const row = (title, text) => numbers.append(element('dt', { textContent: title }), element('dd', { textContent: text }));
  row('frame', (frame.case ? frame.case + ': ' : '') + frame.name + (frame.note ? ' (' + frame.note + ')' : ''));
  row('first', frame.first);
  row('worst', frame.worst);
  row('levels of 255', `max ${short(frame.max)}, mean ${short(frame.mean)}, RMS ${short(frame.rms)}, PSNR ${short(frame.psnr)} dB`);
  row('pixels', `${frame.differing} (${short(frame.percent)} % of drawn)` +
      (frame.perceptual === null ? '' : `; a viewer tells ${frame.perceptual} apart (Yee)`));
  for (const line of frame.shows) row('shows', line);
  // Counts run over decades: the bars are logarithmic.
  const most = Math.log1p(Math.max(1, ...frame.histogram.map(bar => bar[1])));
  for (const [levels, pixels] of frame.histogram) {
    const bar = element('i');
    bar.style.height = 4.6 * Math.log1p(pixels) / most + 'rem';
    by('histogram').append(element('div', { title: `${pixels} pixels differ by ${levels} levels` },
      element('span', { textContent: pixels || '' }), bar, element('span', { textContent: levels })));
  }
}

function draw() {
  document.querySelectorAll('#rows tr').forEach((row, k) => row.classList.toggle('chosen', k === state.frame));
  document.querySelectorAll('#views button[data-view]').forEach(b => b.classList.toggle('on', b.dataset.view === state.view));
  by('zoom').textContent = Math.round(state.zoom * 100) + ' %';
  drawStage();
  drawNumbers();
  Object.assign(document.body.dataset, { frame: state.frame, view: state.view, zoom: state.zoom });
}

function choose(frame) {
  state.frame = Math.max(0, Math.min(data.frames.length - 1, frame));
  const row = by('rows').children[state.frame];
  if (row) row.scrollIntoView({ block: 'nearest' });
  draw();
}
function look(view) { state.view = view; draw(); }
function zoom(factor) { state.zoom = Math.max(0.125, Math.min(32, state.zoom * factor)); draw(); }
function split(to) { state.split = Math.max(0, Math.min(1, to)); drawSplit(); }

const keys = {
  ArrowDown: () => choose(state.frame + 1), j: () => choose(state.frame + 1), ArrowUp: () => choose(state.frame - 1), k: () => choose(state.frame - 1),
  Home: () => choose(0), End: () => choose(data.frames.length - 1), '+': () => zoom(2), '=': () => zoom(2), '-': () => zoom(0.5), 0: () => zoom(1 / state.zoom),
  ArrowLeft: () => split(state.split - 0.02), ArrowRight: () => split(state.split + 0.02),
};
for (const [view, , key] of views) keys[key] = () => look(view);
addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
});

by('summary').textContent = data.summary;
by('messages').append(...data.messages.map(text => element('li', { textContent: text })));
data.frames.forEach((frame, k) => {
  const cells = [(frame.case ? frame.case + ': ' : '') + frame.name, frame.differing, short(frame.percent), short(frame.max), short(frame.rms)];
  by('rows').append(element('tr', { onclick: () => choose(k) }, ...cells.map(text => element('td', { textContent: text }))));
});
for (const [view, title, key] of views) {
  const button = element('button', { onclick: () => look(view) }, title + ' ', element('kbd', { textContent: key }));
  button.dataset.view = view;
  by('views').append(button);
}
by('views').append(element('button', { textContent: '-', onclick: () => zoom(0.5) }), element('span', { id: 'zoom' }),
  element('button', { textContent: '+', onclick: () => zoom(2) }),
  element('span', { innerHTML: '<kbd>up, down</kbd> frames <kbd>left, right</kbd> slider <kbd>+ - 0</kbd> zoom' }));
by('stage').addEventListener('pointermove', event => {
  const image = document.querySelector('#canvas img');
  if (state.view !== 'slider' || !image) return;
  const box = image.getBoundingClientRect();
  split((event.clientX - box.left) / box.width);
});
setInterval(() => {
  state.phase ^= 1;
  const over = document.querySelector('#canvas .over');
  if (state.view === 'flicker' && over) over.style.visibility = state.phase ? 'visible' : 'hidden';
}, 500);
draw();
</script>
</body>
</html>
)page";

} // namespace linkdig::compare
