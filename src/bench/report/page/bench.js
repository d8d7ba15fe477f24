(() => {
"use strict";
const tip = document.getElementById("tip");

function show(sign, x, y) {
    tip.textContent = sign.dataset.tip;
    tip.hidden = false;
    const { width, height } = tip.getBoundingClientRect();
    const right = document.documentElement.clientWidth - width - 4;
    tip.style.left = Math.max(4, Math.min(x + 14, right)) + "px";
    tip.style.top = (y - height - 10 < 4 ? y + 18 : y - height - 10) + "px";
}

const signOf = (event) => event.target.closest("[data-tip]");
addEventListener("pointermove", (event) => {
    const sign = signOf(event);
    if (sign) show(sign, event.clientX, event.clientY);
    else tip.hidden = true;
});
addEventListener("focusin", (event) => {
    const sign = signOf(event);
    if (!sign) return;
    const box = sign.getBoundingClientRect();
    show(sign, box.right, box.top);
});
addEventListener("focusout", () => { tip.hidden = true; });
addEventListener("scroll", () => { tip.hidden = true; }, { passive: true });

for (const name of document.querySelectorAll(".legend li")) {
    const article = name.closest("article");
    const curves = article.querySelectorAll(`.plot .curve[data-curve="${name.dataset.curve}"]`);
    const alone = (on) => {
        article.classList.toggle("alone", on);
        for (const each of curves) each.classList.toggle("shown", on);
    };
    name.addEventListener("pointerenter", () => alone(true));
    name.addEventListener("pointerleave", () => alone(false));
}
})();
