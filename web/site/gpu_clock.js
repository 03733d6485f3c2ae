// SPDX-License-Identifier: MIT
// How long an effect takes in WebGPU: by the device's timestamps where it has them, else by waiting.

const runs = 4;

/** Nanoseconds of one run; 0 where the browser rounds them away. */
async function by_timestamps(device, effect) {
    const timestamps = device.createQuerySet({type: 'timestamp', count: 2});
    const resolved = device.createBuffer({size: 16, usage: GPUBufferUsage.QUERY_RESOLVE | GPUBufferUsage.COPY_SRC});
    const read = device.createBuffer({size: 16, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
    const encoder = device.createCommandEncoder();
    effect().record(encoder, {timestamps});
    encoder.resolveQuerySet(timestamps, 0, 2, resolved, 0);
    encoder.copyBufferToBuffer(resolved, 0, read, 0, 16);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    const [begin, end] = new BigUint64Array(read.getMappedRange());
    [timestamps, resolved, read].forEach((each) => each.destroy());
    return Number(end - begin);
}

async function by_waiting(device, effect) {
    effect().run();
    await device.queue.onSubmittedWorkDone();
    const begin = performance.now();
    for (let i = 0; i < runs; ++i)
        effect().run();
    await device.queue.onSubmittedWorkDone();
    return (performance.now() - begin) / runs;
}

/**
 * @param effect  gives the effect that is there at a time
 * @return milliseconds, and how they were measured
 */
export async function measure(device, effect) {
    let nanoseconds = 0;
    for (let i = 0; i < runs && device.features.has('timestamp-query'); ++i)
        nanoseconds += await by_timestamps(device, effect);
    if (nanoseconds > 0)
        return {milliseconds: nanoseconds / runs / 1e6, how: "by the device's clock"};
    return {milliseconds: await by_waiting(device, effect), how: 'by waiting'};
}
