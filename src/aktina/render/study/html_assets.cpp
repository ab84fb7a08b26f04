// Style and script of report.html: small enough to stand in the page itself.
#include "aktina/render/study/html.h"

namespace aktina {

const std::string_view kStudyStyle = R"css(
:root { color-scheme: light dark; --page: #fcfcfb; --ink: #1b1b1a; --soft: #5d5c58; --line: #deddd8; --card: #f3f2ee;
  --front: #2a62b8; --other: #8d8b84; --good: #1c7a45; --bad: #b3372c; }
@media (prefers-color-scheme: dark) { :root { --page: #191918; --ink: #ecebe6; --soft: #a5a39b; --line: #3a3936;
  --card: #242422; --front: #7fb0f2; --other: #8d8b84; --good: #6cc48f; --bad: #ef8a7e; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1180px; padding: 24px 20px 80px; background: var(--page); color: var(--ink);
  font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 26px; line-height: 1.2; margin: 0 0 8px; }
h2 { font-size: 21px; margin: 48px 0 6px; padding-top: 14px; border-top: 2px solid var(--line); }
h3 { font-size: 16px; margin: 30px 0 6px; }
p, ul { max-width: 80ch; margin: 6px 0 10px; }
header p, .facts, small, figcaption { color: var(--soft); }
.facts, figcaption { font-size: 13px; }
code { font-size: 12.5px; overflow-wrap: anywhere; }
a { color: var(--front); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 13.5px; }
th, td { padding: 4px 10px; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
thead th { font-weight: 600; vertical-align: bottom; color: var(--soft); }
.sortable thead th { cursor: pointer; }
tbody th, thead th:first-child { text-align: left; font-weight: 500; }
td.text { text-align: left; white-space: normal; min-width: 200px; }
tr.best th { color: var(--front); font-weight: 700; }
td.yes { color: var(--good); } td.no { color: var(--bad); }
svg { width: 100%; max-width: 860px; min-width: 560px; height: auto; font: 12px system-ui, sans-serif; }
svg .grid { stroke: var(--line); } svg .axis { stroke: var(--soft); }
svg .tick, svg .name { fill: var(--soft); }
svg .front { fill: none; stroke: var(--front); stroke-width: 2; }
svg .lead { stroke: var(--line); }
svg .line { fill: none; stroke-width: 2; } svg g:hover > .line { stroke-width: 4; } svg g > text { fill: var(--ink); }
svg .c0 { --own: #2a62b8; } svg .c1 { --own: #c2571a; } svg .c2 { --own: #1c7a45; }
svg .c3 { --own: #a3369c; } svg .c4 { --own: #8a7414; } svg .c5 { --own: #1f8a96; }
svg .line { stroke: var(--own); } svg .dot { fill: var(--own); stroke: var(--page); stroke-width: 1; }
svg circle { stroke: var(--page); stroke-width: 2; }
svg .best circle { fill: var(--front); } svg .other circle { fill: var(--other); }
svg g text { paint-order: stroke; stroke: var(--page); stroke-width: 3px; }
svg .best text { fill: var(--ink); font-weight: 600; } svg .other text { fill: var(--soft); }
.stage { position: relative; width: fit-content; max-width: 100%; line-height: 0; }
.stage img { max-width: 100%; height: auto; }
.stage .over { position: absolute; inset: 0; width: 100%; height: 100%; }
.stage .bar { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px; background: #fff;
  box-shadow: 0 0 2px #000; }
.compare input { width: 480px; max-width: 100%; margin: 8px 0; accent-color: var(--front); }
.controls label { margin-right: 14px; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)); gap: 14px; }
figure { margin: 0; padding: 8px; background: var(--card); border-radius: 6px; display: grid;
  grid-template-columns: 1fr 1fr; gap: 4px; align-content: start; }
figure img { width: 100%; height: auto; }
figure .picture, figcaption { grid-column: 1 / -1; }
)css";

const std::string_view kStudyScript = R"js(
for (const table of document.querySelectorAll('table.sortable')) {
  const body = table.tBodies[0];
  table.querySelectorAll('thead th').forEach((head, column) => {
    let up = false;
    head.addEventListener('click', () => {
      up = !up;
      const key = row => column ? parseFloat(row.cells[column].dataset.value) : row.cells[0].textContent;
      const order = (a, b) => {
        const x = key(a), y = key(b);
        if (column && (isNaN(x) || isNaN(y))) return isNaN(x) - isNaN(y);
        return (x < y ? -1 : x > y ? 1 : 0) * (up ? 1 : -1);
      };
      [...body.rows].sort(order).forEach(row => body.append(row));
    });
  });
}
for (const box of document.querySelectorAll('.compare')) {
  const gallery = box.parentElement.querySelector('.gallery');
  const left = box.querySelector('.left'), right = box.querySelector('.right'), kind = box.querySelector('.kind');
  const over = box.querySelector('.over'), under = box.querySelector('.under'), bar = box.querySelector('.bar');
  const range = box.querySelector('input');
  const source = name => {
    const figure = [...gallery.children].find(f => f.dataset.name === name);
    return (figure.querySelector('.' + kind.value) || figure.querySelector('.picture')).src;
  };
  const show = () => { over.src = source(left.value); under.src = source(right.value); };
  const slide = () => {
    over.style.clipPath = 'inset(0 ' + (100 - range.value) + '% 0 0)';
    bar.style.left = range.value + '%';
  };
  right.selectedIndex = Math.min(2, right.length - 1);
  for (const choice of [left, right, kind]) choice.addEventListener('change', show);
  range.addEventListener('input', slide);
  box.querySelector('.stage').addEventListener('pointermove', event => {
    if (event.buttons === 0 && event.pointerType !== 'touch') return;
    const area = event.currentTarget.getBoundingClientRect();
    range.value = 100 * (event.clientX - area.left) / area.width;
    slide();
  });
  show();
  slide();
}
)js";

}  // namespace aktina
