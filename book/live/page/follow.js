// A handle whose place follows from numbers of the state by any function: while it is
// dragged, steps of Gauss and Newton's method change these numbers until the handle is
// at the pointer. `limits` has the least and the greatest value of each number.
live.follow = (label, at, limits) => ({
    label,
    at,
    move(state, ...place) {
        const found = { ...state };
        const names = Object.keys(limits);
        for (let step = 0; step < 12; step += 1) {
            const here = at(found);
            const miss = [0, 1].map((i) => place[i] - here[i]);
            const slopes = names.map((name) => {
                const moved = at({ ...found, [name]: found[name] + 1e-3 });
                return [0, 1].map((i) => (moved[i] - here[i]) / 1e-3);
            });
            // One number or two: without a second, its slopes are 0.
            const [p, q] = [slopes[0], slopes[1] ?? [0, 0]];
            const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
            // Damped where the drawing hardly moves, as for a gaze towards the reader.
            const damping = 0.01 * (dot(p, p) + dot(q, q)) + 1e-9;
            const [pp, qq, pq] = [dot(p, p) + damping, dot(q, q) + damping, dot(p, q)];
            const determinant = pp * qq - pq * pq;
            const [by_p, by_q] = [dot(p, miss), dot(q, miss)];
            const changes = [(by_p * qq - by_q * pq) / determinant, (by_q * pp - by_p * pq) / determinant];
            names.forEach((name, i) => {
                const [low, high] = limits[name];
                found[name] = Math.min(Math.max(found[name] + changes[i], low), high);
            });
        }
        return Object.fromEntries(names.map((name) => [name, found[name]]));
    },
});
