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

/** Moves labels down until none lies on another. */
function spread(points, step) {
    const placed = [];
    for (const point of [...points].sort((a, b) => a.y - b.y)) {
        let y = point.y;
        for (const other of placed)
            if (Math.abs(other.x - point.x) < 110 && y - other.y < step)
                y = other.y + step;
        placed.push({...point, label: y, y});
    }
    return new Map(placed.map(({id, label}) => [id, label]));
}

/** @param points  {id, title, cost, error} */
export function plot(points, {cost, error}) {
    const across = scale(points.map((each) => each.cost), left, width - right);
    const down = scale(points.map((each) => each.error), height - bottom, top);
    const placed = points.map((each) => ({...each, x: across.place(each.cost), y: down.place(each.error)}));
    const labels = spread(placed, 13);
    const lines = [
        ...across.ticks.map((value) => {
            const x = across.place(value).toFixed(1);
            return `<path class="grid" d="M${x} ${top}V${height - bottom}"/><text x="${x}" y="${height - bottom + 16}" text-anchor="middle">${Number(value.toPrecision(2))}</text>`;
        }),
        ...down.ticks.map((value) => {
            const y = down.place(value).toFixed(1);
            return `<path class="grid" d="M${left} ${y}H${width - right}"/><text x="${left - 6}" y="${y}" dy=".35em" text-anchor="end">${Number(value.toPrecision(2))}</text>`;
        }),
        ...placed.map(({id, title, x, y, cost: c, error: e}) => `<a href="#${id}"><title>${escaped(title)}: ${c.toPrecision(3)}, ${e.toFixed(4)}</title>` +
            `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="4.5"/><text x="${(x + 8).toFixed(1)}" y="${labels.get(id).toFixed(1)}" dy=".35em">${escaped(title)}</text></a>`),
        `<text x="${(left + width - right) / 2}" y="${height - 8}" text-anchor="middle">${escaped(cost)}</text>`,
        `<text transform="translate(14 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">${escaped(error)}</text>`,
    ];
    return `<svg class="plot" viewBox="0 0 ${width} ${height}" role="img" aria-label="${escaped(error)} against ${escaped(cost)}">\n${lines.join('\n')}\n</svg>`;
}
