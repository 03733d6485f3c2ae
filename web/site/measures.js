// SPDX-License-Identifier: MIT
// Errors against the truth, as `crease compare` measures them: over all texels that are not background.

const window_side = 8;

/** Sums over windows, each in constant time. */
function summed(width, height, value) {
    const stride = width + 1;
    const sums = new Float64Array(stride * (height + 1));
    for (let y = 0; y < height; ++y) {
        let row = 0;
        for (let x = 0; x < width; ++x) {
            row += value(y * width + x);
            sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
        }
    }
    const down = window_side * stride;
    return (x, y) => {
        const at = y * stride + x;
        return sums[at + down + window_side] - sums[at + down] - sums[at + window_side] + sums[at];
    };
}

/** Root of the mean squared difference. */
export function rmse(test, truth, counts) {
    let sum = 0, count = 0;
    for (let i = 0; i < test.length; ++i)
        if (counts[i]) {
            sum += (test[i] - truth[i]) ** 2;
            ++count;
        }
    return Math.sqrt(sum / count);
}

/** Mean structural similarity of windows of 8 x 8 texels. */
export function ssim(test, truth, counts, width, height) {
    const area = window_side ** 2, c1 = 0.01 ** 2, c2 = 0.03 ** 2;
    const counted = summed(width, height, (i) => counts[i]);
    const a = summed(width, height, (i) => test[i]), b = summed(width, height, (i) => truth[i]);
    const aa = summed(width, height, (i) => test[i] ** 2), bb = summed(width, height, (i) => truth[i] ** 2);
    const ab = summed(width, height, (i) => test[i] * truth[i]);
    let total = 0, windows = 0;
    for (let y = 0; y + window_side <= height; ++y)
        for (let x = 0; x + window_side <= width; ++x) {
            if (counted(x, y) < area)
                continue;
            const mean_a = a(x, y) / area, mean_b = b(x, y) / area;
            const variances = aa(x, y) / area - mean_a ** 2 + bb(x, y) / area - mean_b ** 2;
            const covariance = ab(x, y) / area - mean_a * mean_b;
            total += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
                     ((mean_a ** 2 + mean_b ** 2 + c1) * (variances + c2));
            ++windows;
        }
    return total / windows;
}
