// The page: the details of the selected shot around its pictures, and the keys.

const data = JSON.parse(document.getElementById("data").textContent);
for (const shot of data.shots) {
    shot.id = `${shot.suite}/${shot.shot}`;
    shot.group = shot.changed ? "changed" : shot.verdict;
}
data.groups.splice(data.groups.indexOf("passed"), 0, "changed");
const viewer = new Viewer();
const list = new List(data.shots, data.groups, choose);
const byId = (id) => document.getElementById(id);
let current = null;

function choose(shot) {
    if (!shot || shot === current) return;
    current = shot;
    history.replaceState(null, "", "#" + encodeURIComponent(shot.id));
    list.mark(shot);
    const verdict = byId("shotVerdict");
    verdict.textContent = shot.changed ? `${shot.verdict}, changed` : shot.verdict;
    verdict.className = `verdict ${shot.changed ? "changed" : shot.verdict}`;
    byId("shotName").textContent = shot.id;
    byId("shotReason").textContent = shot.reason || "";
    byId("pictures").hidden = !shot.expected && !shot.got && !shot.difference;
    showFigures(shot);
    showCommands(shot);
    showSources(shot);
    byId("viewer").scrollTop = 0;
    delete byId("panes").dataset.shown;
    viewer.show(shot);
}

function row(title, value, limit = "", beyond = false) {
    const cells = [element("td", {textContent: value, className: beyond ? "beyond" : "", colSpan: limit ? 1 : 2})];
    if (limit) cells.push(element("td", {textContent: `limit ${limit}`}));
    return element("tr", {}, element("th", {textContent: title, scope: "row"}), ...cells);
}

function showFigures(shot) {
    const rows = (shot.figures || []).map(([title, value, limit, beyond]) => row(title, value, limit, beyond));
    if (shot.decision) rows.push(row("decided by", shot.decision));
    if (shot.width) rows.push(row("size", `${shot.width} × ${shot.height}`));
    if (shot.expected && !shot.titles) rows.push(row("golden picture", shot.variant ? `for ${shot.variant}` : "for everybody"));
    if (shot.driver || data.run.driver) rows.push(row("drawn by", shot.driver || data.run.driver));
    if (shot.milliseconds) rows.push(row("time", `${Number(shot.milliseconds.toPrecision(3))} ms`));
    for (const remark of shot.remarks || []) rows.push(row("report", remark));
    byId("figures").replaceChildren(...rows.length ? [element("h3", {textContent: "Figures"}), element("table", {}, ...rows)] : []);
}

async function copy(text, button) {
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        const area = element("textarea", {value: text});
        document.body.append(area);
        area.select();
        document.execCommand("copy");
        area.remove();
    }
    const before = button.dataset.title;
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = before; }, 1200);
}

function showCommands(shot) {
    const parts = [];
    for (const [title, command] of [["Reproduce", shot.reproduce], ["Accept", shot.accept], ["Would pass, in its [[shot]]", shot.toPass]]) {
        if (!command) continue;
        const button = element("button", {type: "button", className: "copy", textContent: "Copy", data: {title: "Copy"}});
        button.addEventListener("click", () => copy(command, button));
        parts.push(element("h3", {textContent: title}),
            element("div", {className: "command"}, element("code", {textContent: command}), button));
    }
    if (shot.noTolerance) parts.push(element("p", {textContent: `No tolerance is sensible: ${shot.noTolerance}`}));
    byId("commands").replaceChildren(...parts);
}

function remarkItem([severity, id, text, file, line, column]) {
    const place = file ? `${file}:${line}:${column}: ` : "";
    return element("li", {className: `remark ${severity}`, textContent: `${place}${severity}: ${text}${id ? ` [${id}]` : ""}`});
}

// Each file with its diagnostics below their lines. Diagnostics without a line in these files are above.
function showSources(shot) {
    const told = shot.diagnostics || [];
    const files = (shot.sources || []).map((index) => data.sources[index]);
    const placed = new Set();
    const parts = files.map(({file, text}) => {
        const lines = text.replace(/\n$/, "").split("\n");
        const items = [];
        lines.forEach((line, index) => {
            const here = told.filter((each) => each[3] === file && each[4] === index + 1);
            here.forEach((each) => placed.add(each));
            items.push(element("li", {textContent: line, className: here.length ? "told" : "", data: {line: index + 1}}), ...here.map(remarkItem));
        });
        return element("details", {open: true}, element("summary", {}, element("strong", {textContent: file})),
            element("div", {className: "source"}, element("ol", {}, ...items)));
    });
    const rest = told.filter((each) => !placed.has(each));
    if (rest.length) parts.unshift(element("div", {className: "source"}, element("ol", {}, ...rest.map(remarkItem))));
    if (parts.length) parts.unshift(element("h3", {textContent: "Scene"}));
    byId("sources").replaceChildren(...parts);
}

function step(by) {
    const shots = list.visible();
    const at = shots.indexOf(current);
    choose(at < 0 ? shots[0] : shots[Math.min(shots.length - 1, Math.max(0, at + by))]);
}

function setFactor(exponent) {
    const slider = byId("factor");
    slider.value = exponent;
    const factor = Number((2 ** Number(slider.value)).toPrecision(3));
    byId("factorText").textContent = factor;
    viewer.setFactor(factor);
}

const keys = {
    j: () => step(1),
    k: () => step(-1),
    x: () => viewer.setSwapped(!viewer.swapped),
    d: () => viewer.toggleHeat(),
    "[": () => setFactor(Number(byId("factor").value) - 1),
    "]": () => setFactor(Number(byId("factor").value) + 1),
    "0": () => viewer.alone(0),
    "1": () => viewer.alone(1),
    "2": () => viewer.alone(2),
    "3": () => viewer.alone(3),
    "+": () => viewer.zoomBy(Math.SQRT2),
    "=": () => viewer.zoomBy(Math.SQRT2),
    "-": () => viewer.zoomBy(Math.SQRT1_2),
    f: () => viewer.fit(),
    z: () => viewer.zoomToDifference(),
    c: () => document.querySelector("#commands .copy")?.click(),
    "/": () => byId("search").focus(),
    "?": () => byId("help").showModal(),
};

document.addEventListener("keydown", (event) => {
    const typing = event.target.id === "search";
    if (typing && event.key === "Escape") event.target.blur();
    if (typing || event.ctrlKey || event.metaKey || event.altKey || byId("help").open) return;
    const action = keys[event.key];
    if (!action) return;
    event.preventDefault();
    action();
});
byId("search").addEventListener("input", (event) => list.search(event.target.value));
byId("helpButton").addEventListener("click", keys["?"]);
byId("swap").addEventListener("click", () => {
    viewer.peeking = false;  // the picture under the pointer stays
    keys.x();
});
byId("swap").addEventListener("pointerenter", () => viewer.peek(true));
byId("swap").addEventListener("pointerleave", () => viewer.peek(false));
byId("mode").addEventListener("click", keys.d);
byId("factor").addEventListener("input", (event) => setFactor(event.target.value));
byId("zoomIn").addEventListener("click", keys["+"]);
byId("zoomOut").addEventListener("click", keys["-"]);
byId("fit").addEventListener("click", keys.f);
byId("place").addEventListener("click", keys.z);

byId("filters").hidden = false;
byId("body").hidden = false;
function fromAddress() {
    const id = decodeURIComponent(location.hash.slice(1));
    return data.shots.find((shot) => shot.id === id);
}
window.addEventListener("hashchange", () => choose(fromAddress()));
choose(fromAddress() || list.groups.flatMap((verdict) => list.matching(verdict))[0]);
