# Plots for the documentation: lines on logarithmic axes, as SVG.
# SPDX-License-Identifier: MIT
import math
import pathlib

COLORS = ("#1b6ca8", "#d98200", "#a83232", "#3a7d44", "#6a4c93", "#555555", "#b0477a")

Line = list[tuple[float, float]]


def draw(path: pathlib.Path, x_label: str, y_label: str, lines: dict[str, Line], *, linear_x: bool = False) -> None:
    """One line for each name, through its points; y is logarithmic, x too unless said."""
    width, height, left, right, top, bottom = 640, 360, 70, 130, 20, 50
    xs = sorted({x for line in lines.values() for x, _ in line})
    ys = [y for line in lines.values() for _, y in line]
    floor, ceiling = math.floor(math.log10(min(ys))), math.ceil(math.log10(max(ys)))

    def x_of(x: float) -> float:
        low, high = xs[0], xs[-1]
        share = (x - low) / (high - low) if linear_x else math.log(x / low) / math.log(high / low)
        return left + share * (width - left - right)

    def y_of(y: float) -> float:
        return height - bottom - (math.log10(y) - floor) / max(ceiling - floor, 1) * (height - top - bottom)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
           f'font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for power in range(floor, ceiling + 1):
        y = y_of(10**power)
        out.append(f'<path d="M{left} {y:.1f}H{width - right}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{10.0**power:g}</text>')
    for x in xs:
        out.append(f'<path d="M{x_of(x):.1f} {height - bottom}v4" stroke="#444"/>')
        out.append(f'<text x="{x_of(x):.1f}" y="{height - bottom + 18}" text-anchor="middle">{x:g}</text>')
    # Names stand at the ends of their lines, moved apart where these are close.
    ends = sorted((y_of(line[-1][1]), name) for name, line in lines.items())
    places: dict[str, float] = {}
    lowest = -math.inf
    for y, name in ends:
        lowest = max(y, lowest + 14)
        places[name] = lowest
    for color, (name, line) in zip(COLORS, lines.items()):
        points = " ".join(f"{x_of(x):.1f},{y_of(y):.1f}" for x, y in line)
        out.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2"/>')
        for x, y in line:
            out.append(f'<circle cx="{x_of(x):.1f}" cy="{y_of(y):.1f}" r="2.5" fill="{color}"/>')
        out.append(f'<text x="{width - right + 8}" y="{places[name] + 4:.1f}" fill="{color}">{name}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 10}" text-anchor="middle">{x_label}</text>')
    out.append(f'<text transform="translate(16 {height / 2}) rotate(-90)" text-anchor="middle">{y_label}</text>')
    path.write_text("\n".join(out + ["</svg>"]) + "\n", encoding="utf-8")
