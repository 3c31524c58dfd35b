# SPDX-License-Identifier: GPL-3.0-or-later
"""Small SVG plots for the page that explains the model: one scale for all, legible at 312 px, on paper of their own."""

import math

WIDTH = 360  # in its own units, in which text is 14 high and indices are 13
SHOWN = 450  # px
LEFT, RIGHT = 62, 342
COLOURS = {"ink": "#1b1f24", "soft": "#57606a", "blue": "#1259a7", "red": "#c24a00", "green": "#00775c", "violet": "#a23685"}
STYLE = (
    "text{font:14px system-ui,'Helvetica Neue',Arial,'DejaVu Sans',sans-serif;fill:#1b1f24}.i{font-size:13px}"
    ".soft{fill:#57606a}.mid{text-anchor:middle}.end{text-anchor:end}.bold{font-weight:600}"
    ".line{fill:none;stroke-width:2;stroke-linejoin:round}.thin{fill:none;stroke:#57606a;stroke-width:1}"
    ".grid{fill:none;stroke:#dfe3e8}.shade{fill:#eceff3}"
)


def number(value):
    """Tenths of a unit are enough to draw, and few enough not to depend on the processor."""
    text = f"{value:.1f}"
    return text[:-2] if text.endswith(".0") else text


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;")


def label(text, index="", rest=""):
    """v with the index c, and what follows."""
    if not index:
        return escaped(text)
    return f'{escaped(text)}<tspan class="i" dy="3">{escaped(index)}</tspan><tspan dy="-3">{escaped(rest)}</tspan>'


def coloured(content, colour):
    return f'<tspan fill="{COLOURS[colour]}">{content}</tspan>'


class Picture:
    def __init__(self, title, height):
        self.title, self.height, self.parts = title, height, []

    def add(self, element):
        self.parts.append(element)

    def text(self, x, y, content, kind=""):
        self.add(f'<text x="{number(x)}" y="{number(y)}"' + (f' class="{kind}"' if kind else "") + f">{content}</text>")

    def line(self, points, colour="ink", dash="", kind="line"):
        path = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.add(f'<path class="{kind}" stroke="{COLOURS[colour]}"{dashed} d="{path}"/>')

    def area(self, points, colour, opacity):
        path = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)
        self.add(f'<path fill="{COLOURS[colour]}" fill-opacity="{opacity}" d="{path}Z"/>')

    def rectangle(self, x, y, width, height, kind):
        self.add(f'<rect class="{kind}" x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}"/>')

    def dot(self, x, y, colour="ink", radius=4.5):
        self.add(f'<circle fill="{COLOURS[colour]}" cx="{number(x)}" cy="{number(y)}" r="{number(radius)}"/>')

    def arrow(self, start, end, colour="ink"):
        """A line with a head at its end."""
        length = math.hypot(end[0] - start[0], end[1] - start[1])
        ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        foot = (end[0] - 8 * ux, end[1] - 8 * uy)
        self.line([start, foot], colour)
        self.area([end, (foot[0] - 4.5 * uy, foot[1] + 4.5 * ux), (foot[0] + 4.5 * uy, foot[1] - 4.5 * ux)], colour, 1)

    def __str__(self):
        return (
            f'<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {self.height}" '
            f'width="{SHOWN}" height="{number(self.height * SHOWN / WIDTH)}" role="img"><title>{escaped(self.title)}</title>'
            f'<style>{STYLE}</style>\n<rect fill="#fff" width="{WIDTH}" height="{self.height}"/>\n' + "\n".join(self.parts) + "\n</svg>\n"
        )


class Axes:
    """A panel of a picture: from data to its units."""

    def __init__(self, picture, top, bottom, x, y, logarithmic=False):
        self.picture, self.top, self.bottom, self.x, self.y, self.logarithmic = picture, top, bottom, x, y, logarithmic

    def right_of(self, x):
        low, high = self.x
        if self.logarithmic:
            x, low, high = math.log(x), math.log(low), math.log(high)
        return LEFT + (x - low) / (high - low) * (RIGHT - LEFT)

    def at(self, x, y):
        low, high = self.y
        return self.right_of(x), self.bottom - (y - low) / (high - low) * (self.bottom - self.top)

    def frame(self, x_ticks, y_ticks, x_name, y_name):
        """Grid, numbers and names; the vertical name stands above the panel, where it can be read."""
        for x in x_ticks:
            self.picture.line([(self.right_of(x), self.top), (self.right_of(x), self.bottom)], "soft", kind="grid")
            self.picture.text(self.right_of(x), self.bottom + 18, f"{x:g}".replace("-", "−"), "soft mid")
        for y in y_ticks:
            height = self.at(self.x[0], y)[1]
            self.picture.line([(LEFT, height), (RIGHT, height)], "soft", kind="grid")
            self.picture.text(LEFT - 6, height + 5, f"{y:g}".replace("-", "−"), "soft end")
        self.picture.rectangle(LEFT, self.top, RIGHT - LEFT, self.bottom - self.top, "thin")
        if x_name:
            self.picture.text((LEFT + RIGHT) / 2, self.bottom + 37, x_name, "mid")
        self.picture.text(8, self.top - 8, y_name)

    def curve(self, xs, ys, colour, dash=""):
        self.picture.line([self.at(x, y) for x, y in zip(xs, ys)], colour, dash)
