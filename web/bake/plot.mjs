// SPDX-License-Identifier: MIT
// Error against cost as SVG. Each point is a link to its picture.

const width = 720, height = 420, left = 56, right = 110, top = 16, bottom = 46;

function escaped(text) {
    return `${text}`.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}

/** Round numbers of a logarithmic axis. */
function ticks(least, most) {
    const all = [];
    for (let power = 10 ** Math.floor(Math.log10(least)); power <= most; power *= 10)
        all.push(...[1, 2, 5].map((digit) => digit * power));
    return all.filter((value) => value >= least && value <= most);
}

function scale(values, begin, end) {
    const least = Math.min(...values) / 1.15, most = Math.max(...values) * 1.15;
    const place = (value) => begin + (end - begin) * Math.log(value / least) / Math.log(most / least);
    return {place, ticks: ticks(least, most)};
}

/** Where the label of each point goes: beside, above or below it, where it lies on no other label and on no point. */
function labelled(points) {
    const line = 12, glyph = 6;
    const taken = points.map(({x, y}) => ({x: x - 5, y: y - 5, width: 10, height: 10}));
    const free = (box) => !taken.some((other) => box.x < other.x + other.width && other.x < box.x + box.width &&
                                                 box.y < other.y + other.height && other.y < box.y + box.height);
    return [...points].sort((a, b) => a.y - b.y).map((point) => {
        const long = glyph * point.title.length;
        const places = [0, 1, -1, 2, -2].flatMap((lines) => [{at: 8, lines, anchor: 'start'}, {at: -8, lines, anchor: 'end'}]);
        const boxes = places.map(({at, lines, anchor}) => ({
            anchor, at: point.x + at, x: point.x + at - (anchor === 'end' ? long : 0), y: point.y + (lines - 0.5) * line, width: long, height: line,
        }));
        const box = boxes.find(free) ?? boxes[0];
        taken.push(box);
        return {...point, label: box};
    });
}

/** @param points  {id, title, cost, error} */
export function plot(points, {cost, error}) {
    const across = scale(points.map((each) => each.cost), left, width - right);
    const down = scale(points.map((each) => each.error), height - bottom, top);
    const placed = points.map((each) => ({...each, x: across.place(each.cost), y: down.place(each.error)}));
    const lines = [
        ...across.ticks.map((value) => {
            const x = across.place(value).toFixed(1);
            return `<path class="grid" d="M${x} ${top}V${height - bottom}"/><text x="${x}" y="${height - bottom + 16}" text-anchor="middle">${Number(value.toPrecision(2))}</text>`;
        }),
        ...down.ticks.map((value) => {
            const y = down.place(value).toFixed(1);
            return `<path class="grid" d="M${left} ${y}H${width - right}"/><text x="${left - 6}" y="${y}" dy=".35em" text-anchor="end">${Number(value.toPrecision(2))}</text>`;
        }),
        ...labelled(placed).map(({id, title, x, y, label, cost: c, error: e}) => `<a href="#${id}"><title>${escaped(title)}: ${c.toPrecision(3)}, ${e.toFixed(4)}</title>` +
            `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="4.5"/><text x="${label.at.toFixed(1)}" y="${(label.y + label.height / 2).toFixed(1)}" dy=".35em" text-anchor="${label.anchor}">${escaped(title)}</text></a>`),
        `<text x="${(left + width - right) / 2}" y="${height - 8}" text-anchor="middle">${escaped(cost)}</text>`,
        `<text transform="translate(14 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">${escaped(error)}</text>`,
    ];
    return `<svg class="plot" viewBox="0 0 ${width} ${height}" role="img" aria-label="${escaped(error)} against ${escaped(cost)}">\n${lines.join('\n')}\n</svg>`;
}
