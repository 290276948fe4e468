// The drawings: the program with its marking, the plant with its modes, at the cursor.

const svgSpace = "http://www.w3.org/2000/svg";

class Drawing {
  constructor(pane, text, missing) {
    this.pane = pane;
    this.svg = null;
    this.nodes = new Map();  // by the title that the layout gave
    pane.replaceChildren();
    if (!text) {
      pane.append(make("p", "missing", missing || "There is no such drawing."));
      return;
    }
    const parsed = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    this.svg = document.importNode(parsed, true);
    const box = this.svg.viewBox.baseVal;
    const margin = 8;  // a badge hangs over its block
    this.whole = {x: box.x - margin / 2, y: box.y - margin / 2, width: box.width + margin, height: box.height + 2 * margin};
    this.svg.removeAttribute("width");
    this.svg.removeAttribute("height");
    this.svg.setAttribute("preserveAspectRatio", "xMidYMid meet");
    for (const group of this.svg.querySelectorAll("g.node, g.cluster")) {
      const title = group.querySelector(":scope > title");
      if (!title) continue;
      group.dataset.title = title.textContent;
      this.nodes.set(title.textContent, group);
    }
    // The paper of the drawing is the page's.
    const paper = this.svg.querySelector("g.graph > polygon");
    if (paper) paper.remove();
    for (const title of this.svg.querySelectorAll("title")) title.remove();
    pane.append(this.svg);
    this.fit();
    this.listen();
  }

  fit() {
    if (this.svg) this.look(this.whole);
  }

  look(box) {
    this.box = {...box};
    this.svg.setAttribute("viewBox", [box.x, box.y, box.width, box.height].map((n) => n.toFixed(2)).join(" "));
  }

  listen() {
    const pane = this.pane;
    let last = null;
    pane.onpointerdown = (event) => {
      last = event;
      pane.setPointerCapture(event.pointerId);
    };
    pane.onpointermove = (event) => {
      if (!last) return;
      const scale = this.scale();
      this.look({...this.box, x: this.box.x - (event.clientX - last.clientX) * scale, y: this.box.y - (event.clientY - last.clientY) * scale});
      last = event;
    };
    pane.onpointerup = pane.onpointercancel = () => (last = null);
    pane.onwheel = (event) => {
      event.preventDefault();
      const frame = this.svg.getBoundingClientRect();
      const factor = Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * (event.ctrlKey ? 0.012 : 0.004));
      const scale = this.scale();
      const atX = this.box.x + this.box.width / 2 + (event.clientX - frame.left - frame.width / 2) * scale;
      const atY = this.box.y + this.box.height / 2 + (event.clientY - frame.top - frame.height / 2) * scale;
      const width = Math.max(40, Math.min(this.whole.width * 3, this.box.width * factor));
      const ratio = width / this.box.width;
      this.look({x: atX - (atX - this.box.x) * ratio, y: atY - (atY - this.box.y) * ratio, width, height: this.box.height * ratio});
    };
    pane.onkeydown = (event) => {
      const step = 60 * this.scale();
      const move = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]}[event.key];
      if (!move) return;
      this.look({...this.box, x: this.box.x + move[0], y: this.box.y + move[1]});
      event.preventDefault();
      event.stopPropagation();
    };
  }

  /** How much of the drawing a pixel is. */
  scale() {
    const frame = this.svg.getBoundingClientRect();
    return Math.max(this.box.width / Math.max(frame.width, 1), this.box.height / Math.max(frame.height, 1));
  }

  /** Pixels for a point, at least, in what is followed. */
  get legible() {
    return 0.8;
  }

  /** Brings groups into the middle, at a size that can be read, where the whole would be too small. */
  show(groups) {
    const frame = this.svg?.getBoundingClientRect();
    if (!groups.length || !frame?.width) return;
    const {legible} = this;
    if (Math.min(frame.width / this.whole.width, frame.height / this.whole.height) >= legible) return this.fit();
    const boxes = groups.map((group) => boxIn(this.svg, group));
    const left = Math.min(...boxes.map((b) => b.x)), right = Math.max(...boxes.map((b) => b.x + b.width));
    const top = Math.min(...boxes.map((b) => b.y)), bottom = Math.max(...boxes.map((b) => b.y + b.height));
    const width = Math.min(this.whole.width, Math.max(frame.width / legible, 0));
    const height = width * (frame.height / frame.width);
    const middle = (low, high, size, least, most) => (size >= most ? least + (most - size) / 2 : Math.max(least, Math.min(least + most - size, (low + high - size) / 2)));
    this.look({x: middle(left, right, width, this.whole.x, this.whole.width), y: middle(top, bottom, height, this.whole.y, this.whole.height), width, height});
  }
}

/** The box of a group in the coordinates of the whole drawing. */
function boxIn(svg, group) {
  const box = group.getBBox();
  const matrix = svg.querySelector("g.graph").transform.baseVal.consolidate()?.matrix;
  return {x: box.x + (matrix?.e ?? 0), y: box.y + (matrix?.f ?? 0), width: box.width, height: box.height};
}

class ProgramDrawing extends Drawing {
  mark(flight, time, follow) {
    if (!this.svg) return;
    const marking = flight.marking.at(time) ?? [];
    const key = marking.join();
    if (key === this.marked) return;
    this.marked = key;
    for (const group of this.svg.querySelectorAll(".marked")) group.classList.remove("marked");
    const groups = [];
    for (const location of marking) {
      const node = this.nodes.get("l" + (location + 1)) ?? this.nodes.get("cluster_l" + (location + 1));
      if (!node) continue;
      node.classList.add("marked");
      if (!flight.model.locations[location].composite) groups.push(node);
    }
    if (follow) this.show(groups);
  }
}

class PlantDrawing extends Drawing {
  constructor(pane, text, missing, model) {
    super(pane, text, missing);
    this.model = model;
    this.badges = [];
    if (!this.svg) return;
    for (const [, group] of this.nodes) {
      const path = group.querySelector("a")?.getAttribute("xlink:title") ?? group.querySelector("a")?.getAttributeNS("http://www.w3.org/1999/xlink", "title");
      if (path) this.badges.push({group, path, index: model.components.findIndex((c) => c.name === path)});
    }
  }

  mark(flight, time, follow, chosen) {
    if (!this.svg || !this.pane.offsetParent) return;
    if (follow) this.follow(flight, time, chosen);
    for (const badge of this.badges) {
      const shown = badge.index >= 0 ? [badge.index] : this.model.components.map((c, i) => (c.name.startsWith(badge.path + ".") ? i : -1)).filter((i) => i >= 0);
      const modes = shown.map((c) => [this.model.components[c], flight.modes[c]?.at(time)]).filter(([, mode]) => mode !== undefined);
      const bad = modes.filter(([component, mode]) => isFault(component, mode));
      const text = badge.index >= 0 ? modes.map(([component, mode]) => component.modes[mode]).join() : this.faultsIn(badge.path, bad);
      const tone = bad.length ? "fault" : modes.length ? toneOf(...modes[0]) : "rest";
      if (badge.text === text && badge.tone === tone) continue;
      Object.assign(badge, {text, tone});
      badge.element?.remove();
      badge.element = text ? this.badge(badge.group, text, tone) : null;
    }
  }

  /** What is amiss in a folded module: its name where there is room for one. */
  faultsIn(path, bad) {
    if (bad.length > 1) return bad.length + " faults";
    return bad.map(([component, mode]) => component.name.slice(path.length + 1) + " = " + component.modes[mode]).join();
  }

  get legible() {
    return 0.85;  // its texts are smaller than a program's
  }

  /** Where to look: at what was chosen last, or what changed last. */
  follow(flight, time, chosen) {
    const since = Math.max(...flight.modes.map((track) => track.times[track.find(time)] ?? 0));
    const changed = flight.modes.flatMap((track, c) => (since > 0 && track.times[track.find(time)] === since ? [c] : []));
    const seen = chosen >= 0 && chosen !== this.chosen ? [chosen] : since !== this.marked ? changed : null;
    [this.chosen, this.marked] = [chosen, since];
    if (!seen) return;
    const names = seen.map((c) => this.model.components[c].name);
    const isSeen = (path) => names.some((name) => name === path || name.startsWith(path + "."));
    const groups = this.badges.filter((badge) => isSeen(badge.path)).map((badge) => badge.group);
    if (groups.length) this.show(groups);
    else this.fit();
  }

  /** A mode on the lower edge of its block. */
  badge(group, text, tone) {
    const box = group.getBBox();
    const badge = document.createElementNS(svgSpace, "g");
    badge.setAttribute("class", "badge");
    const label = document.createElementNS(svgSpace, "text");
    const plate = document.createElementNS(svgSpace, "rect");
    label.textContent = text;
    badge.append(plate, label);
    group.append(badge);
    const wide = label.getComputedTextLength() + 12;
    const x = box.x + box.width / 2, y = box.y + box.height;
    label.setAttribute("x", x);
    label.setAttribute("y", y + 3.5);
    label.style.fill = "var(--" + ({fault: "fault-ink", rest: "rest-ink"}[tone] ?? "m-ink") + ")";
    for (const [name, value] of Object.entries({x: x - wide / 2, y: y - 7, width: wide, height: 14, rx: 7})) plate.setAttribute(name, value);
    plate.style.fill = "var(--" + tone + ")";
    return badge;
  }
}
