// Engines of today behind one interface: boxes, balls, convex hulls and level planes of a scene file, without sleep. Each loader takes the
// folder where the packages are, throws if its own is not there, and gives a class with title, version and settings, of
// which the first is as shipped and the last the engine's best that was found.
//   new Engine(scene, setting)   scene: what `pushfactor scene` prints; setting: one of its settings
//   step()                       one step of the setting's length
//   bodies()                     of bodies with mass: {name, position [m], orientation (w, x, y, z), velocity [m/s]}
const isMovable = (body) => body.mass_kg !== undefined;
const half = (body) => body.size_m.map((edge) => edge / 2);

const load = async (folder, name, path = "") => import(new URL(`node_modules/${name}/${path}`, folder).href);

const rapier = async (folder) => {
    const RAPIER = (await load(folder, "@dimforge/rapier3d-compat", "dist/rapier.mjs")).default;
    const warn = console.warn;
    console.warn = () => {};  // of its own way to start
    await RAPIER.init();
    console.warn = warn;
    const vector = ([x, y, z]) => ({x, y, z});
    const turn = ([w, x, y, z]) => ({w, x, y, z});
    return class {
        static title = "Rapier";
        static version = RAPIER.version();
        static settings = [
            {name: "as shipped", dt: 1 / 60},
            {name: "50 iterations, 1/240 s", dt: 1 / 240, tune: (p) => { p.numSolverIterations = 50; }},
        ];
        constructor(scene, {dt, tune}) {
            this.world = new RAPIER.World(vector(scene.gravity_m_per_s2));
            this.world.integrationParameters.dt = dt;
            if (tune) tune(this.world.integrationParameters);
            this.movable = [];
            for (const body of scene.bodies) {
                const kind = isMovable(body) ? RAPIER.RigidBodyDesc.dynamic().setCanSleep(false) : RAPIER.RigidBodyDesc.fixed();
                const made = this.world.createRigidBody(kind.setTranslation(...body.position_m).setRotation(turn(body.orientation_wxyz)));
                const shape = body.shape === "plane" ? new RAPIER.ColliderDesc(new RAPIER.HalfSpace(vector([0, 1, 0])))
                    : body.shape === "box" ? RAPIER.ColliderDesc.cuboid(...half(body))
                    : body.shape === "polyhedron" ? RAPIER.ColliderDesc.convexHull(new Float32Array(body.points_m.flat())) : RAPIER.ColliderDesc.ball(body.radius_m);
                shape.setFriction(body.friction).setRestitution(0);
                if (isMovable(body)) {
                    shape.setMass(body.mass_kg);
                    this.movable.push({name: body.name, made});
                }
                this.world.createCollider(shape, made);
            }
        }
        step() { this.world.step(); }
        bodies() {
            return this.movable.map(({name, made}) => {
                const p = made.translation(), q = made.rotation(), v = made.linvel();
                return {name, position: [p.x, p.y, p.z], orientation: [q.w, q.x, q.y, q.z], velocity: [v.x, v.y, v.z]};
            });
        }
        free() { this.world.free(); }
    };
};

const jolt = async (folder) => {
    const Jolt = await (await load(folder, "jolt-physics", "dist/jolt-physics.wasm-compat.js")).default();
    const version = "1.1.0";
    const vector = ([x, y, z]) => new Jolt.RVec3(x, y, z);
    const still = 0, moving = 1;
    const roundest = 0.05;  // m, how far a shape's edges are rounded as it is shipped; not more than a thin box has
    const hull = (points) => {
        const settings = new Jolt.ConvexHullShapeSettings();
        for (const point of points) settings.mPoints.push_back(new Jolt.Vec3(...point));
        return settings.Create().Get();
    };
    return class {
        static title = "Jolt";
        static version = version;
        static settings = [
            {name: "as shipped", dt: 1 / 60, parts: 1},
            {name: "200 and 20 iterations, slop of 1 mm, 1/960 s", dt: 1 / 960, parts: 1, tune: (s) => {
                s.mNumVelocitySteps = 200;
                s.mNumPositionSteps = 20;
                s.mPenetrationSlop = 0.001;
            }},
        ];
        constructor(scene, {dt, parts, tune}) {
            this.dt = dt;
            this.parts = parts;
            const filter = new Jolt.ObjectLayerPairFilterTable(2);
            filter.EnableCollision(still, moving);
            filter.EnableCollision(moving, moving);
            const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
            layers.MapObjectToBroadPhaseLayer(still, new Jolt.BroadPhaseLayer(0));
            layers.MapObjectToBroadPhaseLayer(moving, new Jolt.BroadPhaseLayer(1));
            const settings = new Jolt.JoltSettings();
            settings.mObjectLayerPairFilter = filter;
            settings.mBroadPhaseLayerInterface = layers;
            settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, filter, 2);
            this.jolt = new Jolt.JoltInterface(settings);
            Jolt.destroy(settings);
            const physics = this.jolt.GetPhysicsSystem(), bodies = physics.GetBodyInterface();
            physics.SetGravity(new Jolt.Vec3(...scene.gravity_m_per_s2));
            if (tune) {
                const own = physics.GetPhysicsSettings();
                tune(own);
                physics.SetPhysicsSettings(own);
            }
            this.movable = [];
            for (const body of scene.bodies) {
                // A plane reaches as far as it has to here.
                const shape = body.shape === "plane" ? new Jolt.BoxShape(new Jolt.Vec3(1000, 1, 1000))
                    : body.shape === "box" ? new Jolt.BoxShape(new Jolt.Vec3(...half(body)), Math.min(roundest, ...half(body)))
                    : body.shape === "polyhedron" ? hull(body.points_m) : new Jolt.SphereShape(body.radius_m);
                const [w, x, y, z] = body.orientation_wxyz;
                const [px, py, pz] = body.position_m;
                const place = vector([px, body.shape === "plane" ? py - 1 : py, pz]);
                const own = new Jolt.BodyCreationSettings(shape, place, new Jolt.Quat(x, y, z, w),
                    isMovable(body) ? Jolt.EMotionType_Dynamic : Jolt.EMotionType_Static, isMovable(body) ? moving : still);
                own.mFriction = body.friction;
                own.mRestitution = 0;
                own.mAllowSleeping = false;
                own.mLinearDamping = own.mAngularDamping = 0;
                if (isMovable(body)) {
                    own.mOverrideMassProperties = Jolt.EOverrideMassProperties_CalculateInertia;
                    own.mMassPropertiesOverride.mMass = body.mass_kg;
                }
                const made = bodies.CreateBody(own);
                bodies.AddBody(made.GetID(), Jolt.EActivation_Activate);
                if (isMovable(body)) this.movable.push({name: body.name, made});
            }
        }
        step() { this.jolt.Step(this.dt, this.parts); }
        bodies() {
            return this.movable.map(({name, made}) => {
                const p = made.GetCenterOfMassPosition(), q = made.GetRotation(), v = made.GetLinearVelocity();
                return {name, position: [p.GetX(), p.GetY(), p.GetZ()], orientation: [q.GetW(), q.GetX(), q.GetY(), q.GetZ()],
                    velocity: [v.GetX(), v.GetY(), v.GetZ()]};
            });
        }
        free() { Jolt.destroy(this.jolt); }
    };
};

const mujoco = async (folder) => {
    const mj = await (await load(folder, "@mujoco/mujoco", "mujoco.js")).default();
    const xml = (scene, {dt, options, flags}) => {
        const numbers = (list) => list.join(" ");
        const meshes = new Map();
        const meshOf = (points) => {
            const text = numbers(points.flat());
            if (!meshes.has(text)) meshes.set(text, `hull ${meshes.size}`);
            return meshes.get(text);
        };
        const bodies = scene.bodies.map((body) => {
            const shape = body.shape === "plane" ? `type="plane" size="0 0 1" zaxis="0 1 0"`
                : body.shape === "box" ? `type="box" size="${numbers(half(body))}"`
                : body.shape === "polyhedron" ? `type="mesh" mesh="${meshOf(body.points_m)}"` : `type="sphere" size="${body.radius_m}"`;
            const geom = `<geom ${shape} friction="${body.friction} 0 0"${isMovable(body) ? ` mass="${body.mass_kg}"` : ""}/>`;
            const place = `pos="${numbers(body.position_m)}"${body.shape === "plane" ? "" : ` quat="${numbers(body.orientation_wxyz)}"`}`;
            return isMovable(body) ? `<body name="${body.name}" ${place}><freejoint/>${geom}</body>` : `<body ${place}>${geom}</body>`;
        });
        return `<mujoco><option timestep="${dt}" gravity="${numbers(scene.gravity_m_per_s2)}" ${options || ""}>${flags || ""}</option><asset>${[...meshes].map(([text, name]) => `<mesh name="${name}" vertex="${text}"/>`).join("")}</asset><worldbody>${bodies.join("")}</worldbody></mujoco>`;
    };
    return class {
        static title = "MuJoCo";
        static version = mj.mj_versionString();
        static settings = [
            {name: "as shipped, at its own step of 2 ms", dt: 0.002},
            {name: "as shipped, at 1/60 s", dt: 1 / 60},
            {name: "stiff contacts, elliptic cones, 0.5 ms", dt: 1 / 2000, flags: `<flag override="enable"/>`,
                options: `cone="elliptic" iterations="300" tolerance="1e-14" o_solref="0.001 1" o_solimp="0.999 0.99999 0.001 0.5 2"`},
        ];
        constructor(scene, setting) {
            this.model = mj.MjModel.from_xml_string ? mj.MjModel.from_xml_string(xml(scene, setting)) : mj.MjModel.mj_loadXML(xml(scene, setting));
            this.data = new mj.MjData(this.model);
            this.movable = scene.bodies.filter(isMovable).map(({name}) => name);
        }
        step() { mj.mj_step(this.model, this.data); }
        bodies() {
            const {qpos, qvel} = this.data;
            return this.movable.map((name, i) => ({name, position: [...qpos.subarray(7 * i, 7 * i + 3)],
                orientation: [...qpos.subarray(7 * i + 3, 7 * i + 7)], velocity: [...qvel.subarray(6 * i, 6 * i + 3)]}));
        }
        free() {
            this.data.delete();
            this.model.delete();
        }
    };
};

export const engines = {rapier, jolt, mujoco};
