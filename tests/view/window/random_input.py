"""Random input for `glibra-view --replay`: drags, keys, typing, resizes, and opened scenes.

    random_input.py SEED FRAMES SCENE... >FILE
"""

import json
import random
import sys

KEYS = [32, 46, 44, 49, 50, 51, 52, 82, 80, 65, 87, 76, 84, 258, 256, 294, 90, 89, 47, 73, 257, 259, 86, 86, 78, 69, 70, 71, 72, 292]
CONTROL = 341
SHIFT = 340
QUIT = 81
TEXTS = ["1", "-", ".", "9e9", "e", "abc", "0.5", "\t"]


def frames(seed, count, scenes, drops=()):
    drops = [*scenes, *drops]
    choose = random.Random(seed)
    width, height = 980, 600
    x, y, buttons = 0.0, 0.0, 0
    for _ in range(count):
        frame = {}
        kind = choose.random()
        if kind < 0.5:
            x, y = x + choose.uniform(-30, 30), y + choose.uniform(-30, 30)
        elif kind < 0.62:
            x, y = choose.uniform(-20, width + 20), choose.uniform(-20, height + 20)
        elif kind < 0.85:
            buttons ^= 1 << choose.choice([0, 0, 0, 0, 1, 2])
        elif kind < 0.90:
            frame["wheel"] = choose.choice([-3, -1, 1, 3])
        elif kind < 0.95:
            keys = [choose.choice(KEYS)]
            if choose.random() < 0.2:
                keys.append(choose.choice([CONTROL, SHIFT]))
            if QUIT not in keys:
                frame["keys"] = keys
        elif kind < 0.98:
            frame["text"] = choose.choice(TEXTS)
        elif kind < 0.99:
            width, height = choose.randint(1, 1300), choose.randint(1, 850)
            frame["size"] = [width, height]
        elif kind < 0.995:
            frame["open"] = choose.choice(scenes)
        else:
            frame["drop"] = choose.sample(drops, choose.randint(1, 2))
        frame["mouse"] = [round(x, 1), round(y, 1)]
        frame["buttons"] = buttons
        yield frame


if __name__ == "__main__":
    for each in frames(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]):
        print(json.dumps(each))
