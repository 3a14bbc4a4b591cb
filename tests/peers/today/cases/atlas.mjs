import {outcome, words} from "../measures.mjs";
import {stack} from "../scenes.mjs";

export const run = ({page, ours, shipped}) => {
    page.section("Stability atlas: stacks with a heavy cube on top",
        `Cubes of 1 m and 1 kg that touch, the topmost heavier by the ratio; 10 s. ${words} Each cell opens its replay. Settings as shipped; MuJoCo at its own step of 2 ms.`);
    for (const {engine, setting, run} of [ours("default"), ...shipped]) {
        page.grid(engine, setting, "cubes", [2, 3, 5, 10, 20, 40], "ratio", [1, 10, 100, 1e3, 1e4, 1e5, 1e6], (count, ratio) => {
            const scene = stack(count, ratio), trajectory = run(scene, 10);
            return {text: outcome(scene, trajectory), ...page.record(`${engine}, ${count} cubes, ratio ${ratio}`, scene, trajectory, {every: 6})};
        });
    }
};
