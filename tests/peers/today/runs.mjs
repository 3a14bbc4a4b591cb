// Runs of a scene in each engine and here, as trajectories: a list of {time, bodies} with bodies as in engines.mjs, so many a
// second.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";

export const trajectoryOf = (Engine, setting, scene, seconds, perSecond) => {
    const world = new Engine(scene, setting), trajectory = [{time: 0, bodies: world.bodies()}];
    let steps = 0;
    for (let i = 1; i / perSecond <= seconds + 1e-9; ++i) {
        const next = i / perSecond;
        while ((steps + 0.5) * setting.dt < next) {
            world.step();
            ++steps;
        }
        trajectory.push({time: steps * setting.dt, bodies: world.bodies()});
        if (!trajectory.at(-1).bodies.every(({position}) => position.every(Number.isFinite))) break;
    }
    world.free();
    return trajectory;
};

// This engine: the program with these options.
export const ourTrajectory = (program, options, scene, seconds, perSecond, folder) => {
    const file = path.join(folder, "ours.json"), out = path.join(folder, "ours.csv");
    fs.writeFileSync(file, JSON.stringify({...scene, options: undefined}));
    execFileSync(program, ["run", file, ...options, "--rest", "off", "--seconds", String(seconds), "--fps", String(perSecond), "--trajectory", out], {stdio: "pipe"});
    const [head, ...lines] = fs.readFileSync(out, "utf8").trim().split("\n").filter((line) => !line.startsWith("#")).map((line) => line.split(","));
    const at = Object.fromEntries(head.map((name, i) => [name, i]));
    for (const name of [file, out]) fs.rmSync(name);
    const movable = new Map(scene.bodies.map((body, i) => [i, body]).filter(([, body]) => body.mass_kg !== undefined));
    const trajectory = [];
    for (const line of lines) {
        const number = (name) => Number(line[at[name]]), time = number("time_s"), body = movable.get(number("body"));
        if (!trajectory.length || trajectory.at(-1).time !== time) trajectory.push({time, bodies: []});
        if (!body) continue;
        trajectory.at(-1).bodies.push({name: body.name, position: ["x_m", "y_m", "z_m"].map(number), orientation: ["qw", "qx", "qy", "qz"].map(number),
            velocity: ["vx_m_per_s", "vy_m_per_s", "vz_m_per_s"].map(number)});
    }
    return trajectory;
};

// The trajectory in the columns of `pushfactor run --trajectory`, without what engines do not tell; bodies by name.
export const trajectoryCsv = (trajectory) => ["time_s,name,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_per_s,vy_m_per_s,vz_m_per_s",
    ...trajectory.flatMap(({time, bodies}) => bodies.map(({name, position, orientation, velocity}) => [time, `"${name}"`, ...position, ...orientation, ...velocity].join(",")))].join("\n") + "\n";

// The trajectory as a scene of moved bodies, which the program then draws and records like any other.
const colours = ["vermilion", "orange", "blue", "green", "violet"];
export const movedScene = (scene, trajectory, camera) => {
    const movable = scene.bodies.filter((body) => body.mass_kg !== undefined);
    return {
        version: 1, name: scene.name, gravity_m_per_s2: scene.gravity_m_per_s2, contacts: false, ...(camera ? {camera} : {}),
        colours: Object.fromEntries(movable.map(({name}, i) => [name, colours[i % colours.length]])),
        bodies: scene.bodies.map((body) => {
            if (body.mass_kg === undefined) return {name: body.name, shape: body.shape, position_m: body.position_m, ...(body.size_m ? {size_m: body.size_m} : {})};
            const poses = trajectory.slice(1).map(({time, bodies}) => {
                const own = bodies.find(({name}) => name === body.name);
                return {time_s: time, position_m: own.position, orientation_wxyz: own.orientation};
            }).filter(({position_m: place}) => place.every((x) => Number.isFinite(x) && Math.abs(x) < 1e4));
            const {name, shape, size_m: size, radius_m: radius, points_m: points, position_m: position, orientation_wxyz: orientation} = body;
            return {name, shape, static: true, position_m: position, orientation_wxyz: orientation, ...(size ? {size_m: size} : points ? {points_m: points} : {radius_m: radius}),
                ...(poses.length ? {motion: {poses}} : {})};
        }),
    };
};
