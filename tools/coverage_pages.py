"""The pages that tools/coverage.py writes, as text by path."""
import os
import re

BOOKS = {
    "Graphics Shaders": '"Graphics Shaders: Theory and Practice" (Bailey, Cunningham, second edition, 2012).\n'
                        "  The shaders were written anew from the behaviour that the book describes.",
    "OpenGL Shading Language": '"OpenGL Shading Language" (Rost, Licea-Kane, third edition): its bricks, and the\n'
                               "  techniques that it names.",
    "OpenGL with Java": '"Computer Graphics Programming in OpenGL with Java" (Gordon, Clevenger, third edition).',
    "GLSL slides": "a set of lecture slides about GLSL.",
    "Vertex arrays": "two chapters of a course, about vertex arrays and about GLSL.",
}
STATES = {"scene": "with a scene", "elsewhere": "tests, pages, commands", "not yet": "not yet",
          "not possible": "not possible", "no picture": "no picture"}


def title(source, chapter):
    if not chapter:
        return source
    return f"{source}, chapter {chapter}" if chapter.isdigit() else f"{source}: {chapter}"


def page_of(source, chapter):
    name = re.sub(r"[^a-z0-9]+", "-", f"{source} {chapter}".lower()).strip("-")
    return f"docs/chapters/{name}.md"


def by_chapter(rows):
    """{(source, chapter): rows}: the sources in the order of the rows, chapters by number, then those with names."""
    chapters = {}
    for row in rows:
        chapters.setdefault((row.source, row.chapter), []).append(row)
    sources = list(dict.fromkeys(source for source, _ in chapters))
    names = list(chapters)

    def place(key):
        source, chapter = key
        return sources.index(source), not chapter.isdigit(), int(chapter) if chapter.isdigit() else names.index(key)
    return {key: chapters[key] for key in sorted(names, key=place)}


def cell(text):
    return text.replace("|", "\\|")


def link(text, path, page):
    return f"[{text}]({os.path.relpath(path, os.path.dirname(page))})"


def scene_link(scene, page):
    return link(scene.name(), scene.path, page)


def answer_cell(row, page):
    parts = [scene_link(each, page) for each in row.scenes]
    parts += [cell(row.answer)] if row.answer else []
    parts += [link("task", row.task, page)] if row.task else []
    return ", ".join(parts)


def golden_cell(row, page):
    goldens = [each for scene in row.scenes for each in scene.goldens]
    texts = [link(os.path.basename(each)[:-len(".png")], each, page) for each in goldens]
    return ", ".join(texts + ["`Expect`" for scene in row.scenes if not scene.goldens])


def counts_table(rows):
    lines = ["| source | rows | " + " | ".join(STATES.values()) + " |", "|---|" + "---|" * (len(STATES) + 1)]
    for source in [*dict.fromkeys(row.source for row in rows), "all"]:
        own = [row for row in rows if source in (row.source, "all")]
        counts = [sum(row.state() == state for row in own) for state in STATES]
        lines.append(f"| {source} | {len(own)} | " + " | ".join(map(str, counts)) + " |")
    return lines


def unanswered(rows):
    missing = [row for row in rows if row.state() == "not yet"]
    if not missing:
        return ["Every row is answered, or the table says why it cannot be."]
    lines = [f"{len(missing)} rows are not answered yet:", ""]
    for source in dict.fromkeys(row.source for row in missing):
        lines.append(f"- {source}: " + " ".join(row.id for row in missing if row.source == source))
    return lines


def coverage_page(rows):
    page = "docs/coverage.md"
    lines = ["# What answers each row of the sources", "",
             "glibra was made for readers of five sources, which [the list of scenes](../glib/README.md) names. Every",
             "program, picture, technique and exercise of theirs is a row of this page, with the scene, test, page or",
             "command that answers it, and the goldens: the pictures that the tests compare with. *Task* is the scene that",
             "an exercise begins with.", "",
             "`tools/coverage.py` writes this page from the first lines of the scenes and from",
             "`tests/coverage/rows.csv`.", "",
             *counts_table(rows), "", *unanswered(rows), "", "## Chapters by pictures", ""]
    chapters = by_chapter(rows)
    for key, own in chapters.items():
        if count := len(scenes_of(own)):
            lines.append(f"- {link(title(*key), page_of(*key), page)}: {count} scene{'s' if count > 1 else ''}")
    for key, own in chapters.items():
        lines += ["", f"## {title(*key)}", ""]
        if scenes_of(own):
            lines += [f"[The scenes by pictures]({os.path.relpath(page_of(*key), 'docs')})", ""]
        lines += ["| id | what | scene, suite shot or test | golden |", "|---|---|---|---|"]
        lines += [f"| {row.id} | {cell(row.what)} | {answer_cell(row, page)} | {golden_cell(row, page)} |"
                  for row in own]
    return "\n".join(lines + footer("[The example scenes](../glib/README.md) · [README](../README.md)")) + "\n"


def scenes_of(rows):
    return list({scene.path: scene for row in rows for scene in row.scenes}.values())


def picture(scene, page):
    if not scene.goldens:
        return ""
    path = os.path.relpath(scene.goldens[0], os.path.dirname(page))
    return f'<img src="{path}" width="160" alt="{scene.name()}">'


def chapter_page(key, rows):
    page = page_of(*key)
    lines = [f"# {title(*key)}", "", "| picture | scene | rows |", "|---|---|---|"]
    for scene in scenes_of(rows):
        ids = " ".join(row.id for row in rows if scene in row.scenes)
        lines.append(f"| {picture(scene, page)} | {scene_link(scene, page)}<br>{cell(scene.sentence)} | {ids} |")
    tasks = [row for row in rows if row.task]
    if tasks:
        lines += ["", "## Tasks to begin with", "", "| exercise | task | scene to begin with |", "|---|---|---|"]
        lines += [f"| {row.id} | {cell(row.what)} | {link(os.path.basename(row.task), row.task, page)} |"
                  for row in tasks]
    others = [row for row in rows if not row.scenes]
    if others:
        lines += ["", "## Rows without a scene", "", "| id | what | answer |", "|---|---|---|"]
        lines += [f"| {row.id} | {cell(row.what)} | {cell(row.answer)} |" for row in others]
    return "\n".join(lines + footer("[All rows](../coverage.md) · [The example scenes](../../glib/README.md)")) + "\n"


def source_column(rows):
    """For example "Graphics Shaders, chapters 4 and 9; OpenGL with Java, chapter 14"."""
    texts = []
    for source in BOOKS:
        chapters = [row.chapter for row in rows if row.source == source]
        numbers = [str(each) for each in sorted({int(each) for each in chapters if each.isdigit()})]
        if len(numbers) == 1:
            texts.append(f"{source}, chapter {numbers[0]}")
        elif numbers:
            texts.append(f"{source}, chapters {', '.join(numbers[:-1])} and {numbers[-1]}")
        elif chapters:
            texts.append(source)
    return "; ".join(texts) if texts else "-"


def footer(links):
    return ["", "---", "", links]


def scenes_page(rows, scenes):
    page = "glib/README.md"
    lines = ["# The example scenes", "",
             "There is one folder per topic. Shaders are in `shaders/TOPIC`, pictures and volumes in",
             "[textures](../textures/README.md), models in [scenes/models](../scenes/models/README.md). Scenes that",
             "exercises begin with are in `glib/exercises`.", "",
             "The last column says which source and chapter a scene is about, as the window does in its examples:", ""]
    lines += [f"- {source}: {what}" for source, what in BOOKS.items()]
    lines += ["", "[docs/coverage.md](../docs/coverage.md) lists what answers each row of these sources, and has a page",
              "of pictures for every chapter. `tools/coverage.py` writes these pages from the ids (such as SH033) in the",
              "first lines of the scenes.", "", "| scene | what it shows | source |", "|---|---|---|"]
    lines += [f"| {scene_link(each, page)} | {cell(each.sentence)} | {source_column(each.rows)} |" for each in scenes]
    lines += ["", "## Tasks to begin with", "",
              "Each has a file beside it (`.toml`) that names its solution, for [`glibra class`](../docs/class.md) and the",
              "window.", "", "| scene | task | source |", "|---|---|---|"]
    for path in sorted({row.task for row in rows if row.task}):
        own = [row for row in rows if row.task == path]
        name = path[len("glib/"):-len(".glib")]
        lines.append(f"| {link(name, path, page)} | {cell('; '.join(row.what for row in own))} | {source_column(own)} |")
    links = "[README](../README.md) · [Tutorial](../docs/tutorial.md) · [The scene language](../docs/language.md)"
    return "\n".join(lines + footer(links)) + "\n"


def pages(rows, scenes):
    chapters = {page_of(*key): chapter_page(key, own) for key, own in by_chapter(rows).items() if scenes_of(own)}
    return {"docs/coverage.md": coverage_page(rows), "glib/README.md": scenes_page(rows, scenes), **chapters}
