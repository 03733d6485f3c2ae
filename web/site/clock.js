// SPDX-License-Identifier: MIT
// How long a frame takes on the visitor's device: by its own clock where the browser lets it be read, else by waiting.
import {finished} from './gl.js';

const runs = 4;

async function by_query(gl, timer, run) {
    const query = gl.createQuery();
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
    for (let i = 0; i < runs; ++i)
        run();
    gl.endQuery(timer.TIME_ELAPSED_EXT);
    for (let tries = 0; tries < 100 && !gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE); ++tries)
        await new Promise((resolve) => setTimeout(resolve, 20));
    const valid = gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) && !gl.getParameter(timer.GPU_DISJOINT_EXT);
    const nanoseconds = valid ? gl.getQueryParameter(query, gl.QUERY_RESULT) : 0;
    gl.deleteQuery(query);
    return nanoseconds / runs / 1e6;
}

async function by_waiting(gl, run) {
    run();
    await finished(gl);
    const begin = performance.now();
    for (let i = 0; i < runs; ++i)
        run();
    await finished(gl);
    return (performance.now() - begin) / runs;
}

/**
 * @param run  draws a frame
 * @return milliseconds, and how they were measured
 */
export async function measure(gl, run) {
    const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2');
    const milliseconds = timer ? await by_query(gl, timer, run) : 0;
    if (milliseconds > 0)
        return {milliseconds, how: "by the device's clock"};
    return {milliseconds: await by_waiting(gl, run), how: 'by waiting'};
}
