"use strict";
// The page of a class that glibra serves: points and comments are typed into it, and every change is kept at once.

const saved = document.createElement("span");
saved.className = "saved";
saved.setAttribute("role", "status");
document.querySelector("header h1").after(saved);

async function send(change) {
    saved.textContent = "saving ...";
    try {
        const reply = await fetch("marks", {
            method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(change)});
        const answer = await reply.json();
        if (!reply.ok) throw new Error(answer.error || reply.statusText);
        saved.textContent = "saved";
        return answer;
    } catch (problem) {
        saved.textContent = `not saved: ${problem.message}`;
        return null;
    }
}

function show(card, answer) {
    if (!answer) return;
    for (const cell of card.querySelectorAll(".points[data-check]")) {
        const mark = answer.marks.find(each => each.check === cell.dataset.check);
        if (!mark) continue;
        const field = cell.querySelector("input");
        if (document.activeElement !== field) field.value = mark.points;
        cell.parentElement.classList.toggle("own", mark.own);
    }
    const total = card.querySelector(".marks tfoot td");
    const rounded = answer.points === undefined ? "" : String(Math.round(answer.points * 100) / 100);
    if (total) total.textContent = rounded;
    const link = document.querySelector(`.overview a[href="#${card.id}"]`);
    const cell = link && link.closest("tr").querySelector(".points");
    if (cell) cell.textContent = rounded;
}

for (const card of document.querySelectorAll(".card")) {
    const entry = Number(card.id.slice(1)) - 1;
    for (const cell of card.querySelectorAll(".points[data-check]")) {
        const field = document.createElement("input");
        field.type = "number";
        field.min = 0;
        field.max = cell.dataset.most;
        field.step = "any";
        field.value = cell.textContent;
        field.setAttribute("aria-label", `points for ${cell.dataset.check}; empty: those of the check`);
        cell.textContent = "";
        cell.append(field);
        field.addEventListener("change", async () => show(card, await send(
            {entry, check: cell.dataset.check, points: field.value === "" ? null : Number(field.value)})));
    }
    const old = card.querySelector(".comment");
    const comment = document.createElement("textarea");
    comment.rows = 2;
    comment.className = "commentField";
    comment.placeholder = "a comment for this submission";
    comment.setAttribute("aria-label", comment.placeholder);
    comment.value = old ? old.textContent : "";
    if (old) old.remove();
    card.querySelector(".grading").append(comment);
    comment.addEventListener("change", async () => show(card, await send({entry, comment: comment.value})));
}
