// The scenes of the program and the visitor's own, with the options of the command line.
class Scenes {
    constructor(menu, program) {
        this.name = "scenes";
        this.menu = menu;
        this.program = program;
        this.table = [];
        this.scene = "funnel";
        this.preset = "default";
        this.options = new Map();
        this.file = null;  // {name, text}
        this.shows = [];
        this.changed = () => {};
        this.plots = [
            {title: "Energy", unit: "J", of: [["kinetic", "kinetic"], ["potential", "potential"]]},
            {title: "Deepest overlap", unit: "m", of: [["", "overlap"]]},
            {title: "Largest speed", unit: "m/s", of: [["", "speed"]]},
            {title: "Residual of the solver", unit: "m/s", logarithmic: true, of: [["", "residual"]]},
        ];
        $("scene").addEventListener("change", () => {
            const parameters = this.parametersOf(this.scene).map(({name}) => name);
            this.scene = $("scene").value;
            for (const name of parameters) this.options.delete(name);
            if (!this.preset && !this.isFile()) this.preset = "default";
            this.changed();
        });
        $("preset").addEventListener("change", () => {
            this.preset = $("preset").value;
            this.changed();
        });
        $("open").addEventListener("click", () => $("file").click());
        $("file").addEventListener("change", () => {
            if ($("file").files.length) this.openFile($("file").files[0]);
            $("file").value = "";
        });
    }
    async openFile(file) {
        this.file = {name: file.name.replace(/[^\w.-]/g, "_").replace(/(\.json)?$/i, ".json"), text: await file.text()};
        this.options.clear();
        this.preset = "";
        this.scene = this.file.name;
        this.changed();
    }
    isFile() { return Boolean(this.file) && this.file.name === this.scene; }
    parametersOf(scene) {
        const known = this.menu.scenes.find(({name}) => name === scene);
        return known ? known.parameters : [];
    }

    async read(words) {
        this.scene = words.get("scene") || "funnel";
        this.preset = words.get("preset") || (words.has("file") ? "" : "default");
        this.file = null;
        if (words.get("file")) {
            this.file = {name: this.scene, text: new TextDecoder().decode(await inflated(words.get("file").replaceAll("-", "+").replaceAll("_", "/")))};
        }
        this.options = new Map([...words].filter(([name]) => this.menu.options.some((option) => option.name === name) || this.parametersOf(this.scene).some((one) => one.name === name)));
    }
    async words() {
        const words = [["scene", this.scene], ...this.given()];
        if (this.isFile()) words.push(["file", await deflated(this.file.text)]);
        return words;
    }
    async wishes() {
        if (this.isFile()) await this.program.call("keep", this.file.name, this.file.text);
        return [{label: "", scene: this.scene, options: this.given()}];
    }
    given() { return [...(this.preset ? [["preset", this.preset]] : []), ...this.options]; }
    labels() { return [""]; }

    refresh() {}

    write() {
        const names = [...this.menu.scenes.map(({name}) => name), ...(this.file ? [this.file.name] : [])];
        $("scene").replaceChildren(...names.map((name) => new Option(name, name)));
        $("scene").value = this.scene;
        $("preset").replaceChildren(...(this.isFile() ? [new Option("the file's own", "")] : []), ...this.menu.presets.map(({name}) => new Option(name, name)));
        $("preset").value = this.preset;
        const known = this.menu.scenes.find(({name}) => name === this.scene);
        $("sentence").textContent = known ? `${known.sentence[0].toUpperCase()}${known.sentence.slice(1).replace(/\.?$/, ".")} Choose another, or drop a scene file of your own on this page.` : `Your own scene, ${this.scene}.`;
        const change = (name, text) => {
            if (text.trim() === "") this.options.delete(name); else this.options.set(name, text.trim());
            this.changed();
        };
        const input = (name, placeholder) => {
            const made = Object.assign(document.createElement("input"), {type: "text", placeholder, value: this.options.get(name) || "", spellcheck: false, autocomplete: "off"});
            made.dataset.option = name;
            made.addEventListener("change", () => change(name, made.value));
            return made;
        };
        $("parameters").replaceChildren(...this.parametersOf(this.scene).map(({name, help, value}) => {
            const label = document.createElement("label");
            label.className = "field";
            label.title = help;
            label.append(`${name} `, input(name, String(value)));
            return label;
        }));
        $("options").replaceChildren(...this.menu.options.map(({name, help, allowed, values}) => {
            const label = document.createElement("label"), title = document.createElement("b"), text = document.createElement("small");
            title.textContent = name;
            text.textContent = help;
            const field = input(name, !this.preset ? "the file's own" : values[this.preset] || (help.match(/\[(.*)\]$/) || ["", ""])[1]);
            field.title = `must be ${allowed}`;
            label.append(title, field, text);
            return label;
        }));
    }
}

const deflated = async (text) => {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    let binary = "";
    for (const byte of bytes) binary += String.fromCharCode(byte);
    return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
};
