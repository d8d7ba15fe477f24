// The list of shots: groups by verdict, filtered by verdict and text, filled as far as it has been scrolled.

const kChunk = 80;
const kFirstScreen = 24;  // pictures that do not wait until they are in view, as on paper nothing ever is

function element(tag, properties = {}, ...children) {
    const {data, ...others} = properties;
    const made = Object.assign(document.createElement(tag), others);
    Object.assign(made.dataset, data);
    made.append(...children);
    return made;
}

class List {
    constructor(shots, groups, choose) {
        this.shots = shots;
        this.groups = groups;  // verdicts, and "changed" for passes that look different, the most urgent first
        this.choose = choose;
        this.only = new Set();
        this.words = [];
        this.open = new Map(groups.map((verdict) => [verdict, verdict !== "passed" && verdict !== "skipped"]));
        this.root = document.getElementById("list");
        this.observer = new IntersectionObserver(
            (entries) => entries.filter((each) => each.isIntersecting).forEach((each) => each.target.fill()),
            {root: this.root, rootMargin: "600px"});
        this.texts = new Map(shots.map((shot) => [shot, [shot.id, shot.script, shot.reason, shot.variant, shot.driver, shot.group]
            .filter(Boolean).join("\n").toLowerCase()]));
        this.drawChips();
        this.draw();
    }

    matching(verdict) {
        if (this.only.size && !this.only.has(verdict)) return [];
        return this.shots.filter((shot) => shot.group === verdict &&
            this.words.every((word) => this.texts.get(shot).includes(word)));
    }
    isOpen(verdict) { return this.open.get(verdict) || this.only.has(verdict) || this.words.length > 0; }

    // The shots that the keys j and k visit.
    visible() {
        return this.groups.filter((verdict) => this.isOpen(verdict)).flatMap((verdict) => this.matching(verdict));
    }

    search(text) {
        this.words = text.toLowerCase().split(/\s+/).filter(Boolean);
        this.draw();
    }

    drawChips() {
        const chips = this.groups.filter((verdict) => this.shots.some((shot) => shot.group === verdict)).map((verdict) => {
            const count = this.shots.filter((shot) => shot.group === verdict).length;
            const chip = element("button", {type: "button", className: verdict, data: {verdict}, textContent: `${count} ${verdict}`});
            chip.setAttribute("aria-pressed", "false");
            chip.addEventListener("click", () => {
                if (!this.only.delete(verdict)) this.only.add(verdict);
                chip.setAttribute("aria-pressed", String(this.only.has(verdict)));
                this.draw();
            });
            return chip;
        });
        document.getElementById("chips").replaceChildren(...chips);
    }

    draw() {
        this.observer.disconnect();
        this.pictures = 0;
        const groups = [];
        for (const verdict of this.groups) {
            const shots = this.matching(verdict);
            if (shots.length) groups.push(this.group(verdict, shots));
        }
        if (!groups.length) groups.push(element("p", {className: "nothing", textContent: "No shot matches."}));
        this.root.replaceChildren(...groups);
        this.mark(this.current);
    }

    group(verdict, shots) {
        const open = this.isOpen(verdict);
        const heading = element("button", {type: "button", className: verdict, textContent: `${verdict} ${shots.length}`});
        heading.setAttribute("aria-expanded", String(open));
        heading.addEventListener("click", () => {
            this.open.set(verdict, !open);
            this.draw();
        });
        const group = element("section", {className: "group", data: {verdict}}, heading);
        if (!open) return group;
        const items = element("div", {className: verdict === "passed" ? "tiles" : "items"});
        const sentinel = element("div", {className: "sentinel"});
        let next = 0;
        sentinel.fill = () => {
            const count = Math.max(kChunk, next);  // doubles, so that a list of thousands is filled quickly
            const some = shots.slice(next, next + count).map((shot) => this.item(shot));
            next += some.length;
            sentinel.before(...some);
            this.observer.unobserve(sentinel);
            if (next < shots.length) this.observer.observe(sentinel);  // fires immediately if it is still in view
            else sentinel.remove();
        };
        items.append(sentinel);
        group.append(items);
        group.fillTo = (shot) => {
            while (next <= shots.indexOf(shot)) sentinel.fill();
        };
        sentinel.fill();
        return group;
    }

    item(shot) {
        const source = shot.group === "passed" ? shot.got || shot.expected : shot.difference || shot.got || shot.expected;
        const loading = source && ++this.pictures > kFirstScreen ? "lazy" : "eager";
        const picture = source ? element("img", {loading, src: source, alt: "", decoding: "async"}) : element("span", {className: "blank"});
        const item = element("a", {className: "shot", href: "#" + encodeURIComponent(shot.id), title: shot.id, data: {id: shot.id}},
            picture, element("span", {}, element("b", {textContent: shot.id}), element("small", {textContent: shot.reason || ""})));
        item.addEventListener("click", (event) => {
            if (event.ctrlKey || event.metaKey || event.shiftKey) return;
            event.preventDefault();
            this.choose(shot);
        });
        if (shot === this.current) item.setAttribute("aria-current", "true");
        return item;
    }

    mark(shot) {
        this.current = shot;
        this.root.querySelector("[aria-current]")?.removeAttribute("aria-current");
        if (!shot) return;
        const group = [...this.root.children].find((each) => each.dataset.verdict === shot.group);
        if (!group?.fillTo) return;
        group.fillTo(shot);
        const item = [...group.querySelectorAll(".shot")].find((each) => each.dataset.id === shot.id);
        item?.setAttribute("aria-current", "true");
        item?.scrollIntoView({block: "nearest"});
    }
}
