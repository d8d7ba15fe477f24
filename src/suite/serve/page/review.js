// The shots of a review, one at a time or a group at once. All that is accepted has been in view: the page tells the
// server which pictures were, the server refuses the others, and keys wait until the pictures are there.

const byId = (id) => document.getElementById(id);
let data = {shots: [], groups: []};
let current = 0, mode = "two", swapped = false, ready = false;
let subtracts = false;  // a group shows differences

function element(tag, properties = {}, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
}
const source = (shot, what) => `picture?shot=${shot}&what=${what}`;
const order = () => data.groups.flatMap((group) => group.shots);
const groupOf = (shot) => data.groups.find((group) => group.shots.includes(shot));
const openOf = (shots) => shots.filter((shot) => data.shots[shot].got && !data.shots[shot].decided);

async function load() {
    data = await (await fetch("data")).json();
    byId("list").replaceChildren(...data.groups.flatMap((group) => [
        element("h2", {textContent: `${group.cause} (${group.shots.length})`}),
        ...group.shots.map((shot) => {
            const button = element("button", {type: "button", textContent: data.shots[shot].name});
            button.dataset.shot = shot;
            button.dataset.decided = data.shots[shot].decided;
            button.setAttribute("aria-current", String(shot === current));
            button.addEventListener("click", () => choose(shot));
            return button;
        })]));
}

function choose(shot) {
    current = shot;
    swapped = false;
    if (mode === "group") mode = "two";
    show();
}

function shown(shot, what, title) {
    const image = element("img", {src: source(shot, what), alt: title});
    if (what === "got") image.dataset.got = shot;
    return image;
}
function picture(shot, what, title) {
    return element("figure", {}, element("figcaption", {textContent: title}), shown(shot, what, title));
}

// A shot in a group: the golden and the new picture beside each other, or their difference and the new picture, small.
function tile(shot) {
    const {name, decided, size, ...has} = data.shots[shot];
    let pair = [subtracts ? "difference" : "expected", "got"];
    if (swapped) pair.reverse();
    const pictures = element("div", {className: "pair"}, ...pair.filter((what) => has[what]).map((what) => shown(shot, what, what)));
    // At their own size, if that is not tiny or large; known before they are there, so that nothing moves.
    const longest = Math.max(...size, 1), scale = longest > 160 ? 160 / longest : Math.max(1, Math.floor(64 / longest));
    for (const image of pictures.children)
        Object.assign(image.style, {width: `${size[0] * scale}px`, height: `${size[1] * scale}px`});
    const made = element("figure", {title: name}, pictures, element("figcaption", {textContent: name}));
    Object.assign(made.dataset, {shot, state: decided});
    made.addEventListener("click", () => choose(shot));
    return made;
}

// The shots of a group that differ alike, with a button for all of them.
function alike(part) {
    const shots = part.shots.filter((shot) => data.shots[shot].got);
    const accept = element("button", {type: "button", className: "accept"});
    accept.addEventListener("click", () => decide("accept", openOf(shots)));
    accept.count = () => {
        accept.textContent = `Accept these ${openOf(shots).length}`;
        accept.hidden = !openOf(shots).length;
    };
    accept.count();
    return element("section", {}, element("h2", {}, `${part.shots.length} × ${part.difference || data.shots[part.shots[0]].reason} `, accept),
        element("div", {className: "tiles"}, ...shots.map(tile)));
}

// A picture has been seen once half of it, or as much as fits, is in view and decoded. `reported` tells the server.
let seen = new Set(), reported = Promise.resolve();
function look(entries) {
    const now = entries.filter((each) => each.isIntersecting && document.visibilityState === "visible" &&
        each.target.naturalWidth > 0 &&
        (each.intersectionRatio >= .5 || each.intersectionRect.height >= .5 * each.rootBounds.height))
        .map((each) => Number(each.target.dataset.got)).filter((shot) => !seen.has(shot));
    if (!now.length) return;
    for (const shot of now) seen.add(shot);
    reported = reported.then(() => send("see", {shots: now})).then(() => { document.body.dataset.seen = [...seen].join(" "); },
        () => { for (const shot of now) seen.delete(shot); });  // the server did not get it: another look reports it
}
const eye = new IntersectionObserver(look, {threshold: [0, .1, .2, .3, .4, .5]});
function watch() {
    eye.disconnect();
    for (const image of document.querySelectorAll("[data-got]")) eye.observe(image);
}
document.addEventListener("visibilitychange", watch);

// Shows the pictures of the mode, and counts them as seen once they are decoded.
async function show() {
    const shot = data.shots[current];
    ready = false;
    document.body.dataset.ready = "";
    for (const button of document.querySelectorAll("#list button"))
        button.setAttribute("aria-current", String(Number(button.dataset.shot) === current));
    if (!shot) {
        byId("name").textContent = "Nothing has failed.";
        return;
    }
    byId("verdict").textContent = shot.verdict;
    byId("name").textContent = mode === "group" ? groupOf(current).cause : shot.name;
    byId("reason").textContent = shot.reason;
    byId("wipe").hidden = mode !== "wipe";
    document.querySelector("[data-key=A]").hidden = mode !== "group";
    byId("reason").hidden = byId("figures").hidden = mode === "group";
    byId("figures").replaceChildren(...shot.figures.map(([title, value, limit, beyond]) => element("tr", {},
        element("th", {textContent: title}), element("td", {textContent: value, className: beyond ? "beyond" : ""}),
        element("td", {textContent: limit && `limit ${limit}`}))));
    const place = byId("pictures");
    place.className = mode;
    let [first, second] = ["expected", "got"];
    const titles = {expected: shot.titles[0], got: shot.titles[1]};
    if (swapped) [first, second] = [second, first];
    if (mode === "group") {
        place.replaceChildren(...groupOf(current).alike.map(alike));
    } else if (mode === "wipe" && shot.expected && shot.got) {
        const layers = element("div", {className: "layers"},
            shown(current, first, titles[first]), shown(current, second, titles[second]));
        place.replaceChildren(element("figure", {}, element("figcaption", {textContent: `${titles[second]} | ${titles[first]}`}), layers));
        wipe();
    } else if (mode === "difference" && shot.difference) {
        place.replaceChildren(picture(current, "difference", "difference"), ...shot.got ? [picture(current, "got", titles.got)] : []);
    } else {
        place.replaceChildren(...[first, second].filter((what) => shot[what]).map((what) => picture(current, what, titles[what])));
    }
    const chosen = current;
    await Promise.allSettled([...place.querySelectorAll("img")].map((image) => image.decode()));
    if (chosen !== current) return;
    watch();
    ready = true;
    document.body.dataset.ready = String(current);
}

function wipe() {
    const top = document.querySelector(".layers img + img");
    if (top) top.style.clipPath = `inset(0 ${100 - Number(byId("wipe").value)}% 0 0)`;
}

async function send(what, body) {
    const reply = await fetch(what, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)});
    return reply.json();
}

// Shows what has been decided about the shots of the group that is shown, whose pictures stay.
function markDecided() {
    for (const each of document.querySelectorAll("#pictures figure")) each.dataset.state = data.shots[each.dataset.shot].decided;
    for (const each of document.querySelectorAll("#pictures h2 button")) each.count();
    watch();
}

// One line for each reason, however many shots have it.
function sayWhy(refused) {
    const names = new Map();
    for (const [shot, why] of refused) names.set(why, [...names.get(why) || [], data.shots[shot].name]);
    return [...names].map(([why, shots]) => shots.length === 1 ? `${shots[0]}: ${why}` : `${shots.length} shots, as ${shots[0]}: ${why}`);
}

async function decide(what, shots, more = {}) {
    if (!ready || !shots.length) return;
    byId("said").textContent = "";
    // What has just come into view is known after the next frame, which may not have told it yet.
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    look(eye.takeRecords());
    await reported;
    const reply = await send(what, {shots, ...more});
    const refused = reply.refused || [];
    for (const [shot] of refused) seen.delete(shot);
    await load();
    const done = (reply[`${what}ed`] || []).length;
    byId("said").textContent = reply.error || [...done ? [`${done} ${what}ed`] : [], ...sayWhy(refused)].join("\n");
    const blank = refused.filter(([, why]) => why.endsWith("force accepts it")).map(([shot]) => shot);
    if (blank.length && confirm(`${byId("said").textContent}\n\nAccept all the same?`))
        return decide(what, blank, {...more, force: true});
    const next = order().find((shot) => !data.shots[shot].decided && (refused.length === 0 || shot !== current));
    if (mode === "group") {
        // The group stays until all of it is decided; then comes the next one.
        if (refused.length || openOf(groupOf(current).shots).length || next === undefined) return markDecided();
        current = next;
        document.querySelector("main").scrollTop = 0;
        show();
    } else if (!refused.length && next !== undefined) choose(next);
    else show();
}

function step(by) {
    const all = order(), at = all.indexOf(current);
    choose(all[Math.min(all.length - 1, Math.max(0, at + by))]);
}
function toggle(to) {
    mode = mode === to ? "two" : to;
    show();
}

const keys = {
    j: () => step(1),
    k: () => step(-1),
    x: () => { swapped = !swapped; show(); },
    w: () => toggle("wipe"),
    d: () => {
        if (mode !== "group") return toggle("difference");
        subtracts = !subtracts;
        show();
    },
    g: () => toggle("group"),
    a: () => decide("accept", [current]),
    b: () => decide("accept", [current], {also: true}),
    r: () => decide("reject", [current]),
    A: () => mode === "group" && decide("accept", openOf(groupOf(current).shots)),
};
document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
});
for (const button of document.querySelectorAll("[data-key]")) button.addEventListener("click", keys[button.dataset.key]);
byId("wipe").addEventListener("input", wipe);
load().then(() => choose(order()[0] ?? 0));
