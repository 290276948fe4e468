// The timeline: rows over one axis of time, drawn on a canvas of the size of what is seen.

const rowHeight = 26, childHeight = 21, curveHeight = 64;

class Timeline extends Bars {
  constructor(state) {
    super();
    this.state = state;
    this.rows = byId("rows");
    this.scroll = byId("scroll");
    this.plot = byId("plot");
    this.overview = byId("overview");
    this.ruler = byId("ruler");
    this.axis = make("canvas");
    this.ruler.append(this.axis);
    this.shown = [];
    this.active = 0;
    this.listen();
    new ResizeObserver(() => this.resize()).observe(byId("timeline"));
  }

  /** Puts up the rows of a flight, or of what is open of it. */
  build() {
    const {rows, quiet} = this.state.rows;
    this.shown = [];
    const add = (row) => {
      this.shown.push(row);
      if (row.open) for (const child of row.children) this.shown.push(child);
    };
    rows.forEach(add);
    if (this.state.all) quiet.forEach(add);
    else if (quiet.length) this.shown.push(new Row(quiet.length + (quiet.length === 1 ? " row" : " rows") + " in which nothing changes", [], {note: true}));
    let top = 0;
    this.rows.replaceChildren(...this.shown.map((row, i) => {
      row.top = top;
      row.height = row.curve ? curveHeight : row.child ? childHeight : rowHeight;
      const element = this.element(row, i);
      element.style.top = top + "px";
      element.style.height = row.height + "px";
      top += row.height;
      return element;
    }));
    this.rows.style.height = top + "px";
    this.rows.setAttribute("aria-rowcount", this.shown.length);
    this.active = Math.min(this.active, this.shown.length - 1);
    this.rove();
    this.resize();
  }

  element(row, index) {
    const mark = make("span", "mark", row.children.length ? (row.open ? "\u25be" : "\u25b8") : "");
    mark.setAttribute("aria-hidden", "true");
    row.valueElement = make("span", "value");
    row.valueElement.setAttribute("role", "gridcell");
    const text = make("span", "text", row.label);
    text.title = row.component >= 0 && !row.child ? row.label + " : " + this.state.flight.model.components[row.component].type : row.label;
    text.setAttribute("role", "rowheader");
    const label = make("div", "label", row.note ? null : mark, text, row.note ? null : row.valueElement);
    const element = make("div", "row" + (row.head ? " head" : "") + (row.child ? " child" : "") + (row.note ? " note" : ""), label, make("div", "lane"));
    element.setAttribute("role", "row");
    element.setAttribute("aria-level", row.child ? 2 : 1);
    if (row.children.length) element.setAttribute("aria-expanded", row.open);
    element.dataset.index = index;
    element.tabIndex = -1;
    label.addEventListener("click", () => this.toggle(index));
    row.element = element;
    row.said = null;
    return element;
  }

  toggle(index) {
    const row = this.shown[index];
    if (!row) return;
    if (row.note) {
      this.state.setAll(true);
      return;
    }
    if (row.component >= 0) this.state.choose(row.component);
    if (!row.children.length) return;
    const focused = this.rows.contains(document.activeElement);
    row.open = !row.open;
    this.active = index;
    this.build();
    if (focused) this.shown[this.active].element.focus();
  }

  rove() {
    this.shown.forEach((row, i) => (row.element.tabIndex = i === this.active ? 0 : -1));
  }

  listen() {
    let dragging = false;
    const follow = (event) => this.state.setCursor(this.state.snap(this.timeAt(event.clientX - this.scroll.getBoundingClientRect().left)));
    for (const target of [this.ruler, this.rows]) {
      target.addEventListener("pointerdown", (event) => {
        if (event.button !== 0 || event.target.closest(".label")) return;
        dragging = true;
        target.setPointerCapture(event.pointerId);
        const row = this.shown[event.target.closest(".row")?.dataset.index];
        if (row?.component >= 0) this.state.choose(row.component);
        follow(event);
      });
      target.addEventListener("pointermove", (event) => (dragging ? follow(event) : this.tip(event)));
      target.addEventListener("pointerup", () => (dragging = false));
      target.addEventListener("pointercancel", () => (dragging = false));
      target.addEventListener("pointerleave", () => (byId("tip").hidden = true));
      target.addEventListener("dblclick", (event) => {
        if (!event.target.closest(".label")) this.state.zoom(0.25, this.timeAt(event.clientX - this.scroll.getBoundingClientRect().left));
      });
    }
    byId("timeline").addEventListener("wheel", (event) => {
      const x = event.clientX - this.scroll.getBoundingClientRect().left;
      if (event.ctrlKey || event.metaKey) {
        event.preventDefault();
        this.state.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.01), this.timeAt(Math.max(x, this.labels)));
      } else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        event.preventDefault();
        const {from, to} = this.state.view;
        this.state.pan(((event.deltaX || event.deltaY) / this.width) * (to - from));
      }
    }, {passive: false});
    this.scroll.addEventListener("scroll", () => this.draw());
    this.rows.addEventListener("keydown", (event) => this.key(event));
    this.listenToOverview();
  }

  key(event) {
    const move = {ArrowUp: -1, ArrowDown: 1, PageUp: -10, PageDown: 10}[event.key];
    if (move) {
      this.active = Math.max(0, Math.min(this.shown.length - 1, this.active + move));
      this.rove();
      const row = this.shown[this.active];
      row.element.focus();
      row.element.scrollIntoView({block: "nearest"});
      if (row.component >= 0) this.state.choose(row.component);
    } else if (event.key === "Enter") {
      this.toggle(this.active);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** Dragging in the overview chooses a span; a click goes there. */
  listenToOverview() {
    let begun = null;
    const time = (event) => {
      const box = this.overview.getBoundingClientRect();
      return ((event.clientX - box.left - this.labels) / this.width) * this.state.flight.end;
    };
    this.overview.addEventListener("pointerdown", (event) => {
      begun = time(event);
      this.overview.setPointerCapture(event.pointerId);
    });
    this.overview.addEventListener("pointermove", (event) => {
      if (begun === null) return;
      const now = time(event);
      if (Math.abs(now - begun) > this.state.flight.end / 300) this.state.setView(Math.min(begun, now), Math.max(begun, now));
    });
    this.overview.addEventListener("pointerup", (event) => {
      const now = time(event);
      if (begun !== null && Math.abs(now - begun) <= this.state.flight.end / 300) {
        const half = (this.state.view.to - this.state.view.from) / 2;
        this.state.setView(now - half, now + half);
        this.state.setCursor(this.state.snap(now));
      }
      begun = null;
    });
  }

  tip(event) {
    const tip = byId("tip");
    const box = this.scroll.getBoundingClientRect();
    const row = this.shown[event.target.closest?.(".row")?.dataset.index];
    const x = event.clientX - box.left;
    if (!row || row.note || x < this.labels) {
      tip.hidden = true;
      return;
    }
    const time = this.timeAt(x);
    const near = row.marks?.reduce((best, mark) => (Math.abs(this.x(mark.time) - x) < Math.abs((best ? this.x(best.time) : -99) - x) ? mark : best), null);
    const mark = near && Math.abs(this.x(near.time) - x) < 9 ? near : null;
    const span = row.at(time);
    if (!mark && !span) {
      tip.hidden = true;
      return;
    }
    const share = span && span.share < 1 && !span.title ? ", believed to " + Math.round(span.share * 100) + " %" : "";
    tip.replaceChildren(...(mark
      ? [make("b", "", mark.kind + " at " + clockText(mark.time)), mark.text]
      : [make("b", "", row.label + (span.title ? "" : " = " + span.text)), (span.title ? span.title + ": " : "") + clockText(span.from) + " \u2013 " + clockText(span.to) + share]));
    tip.hidden = false;
    const own = byId("timeline").getBoundingClientRect();
    tip.style.left = Math.max(4, Math.min(event.clientX - own.left + 12, own.width - tip.offsetWidth - 8)) + "px";
    tip.style.top = Math.min(event.clientY - own.top + 16, own.height - tip.offsetHeight - 4) + "px";
  }

  resize() {
    byId("timeline").style.setProperty("--labels", this.labels + "px");
    const fit = (canvas, width, height) => {
      const scale = window.devicePixelRatio || 1;
      canvas.width = Math.round(width * scale);
      canvas.height = Math.round(height * scale);
      canvas.style.width = width + "px";
      canvas.style.height = height + "px";
      const pen = canvas.getContext("2d");
      pen.setTransform(scale, 0, 0, scale, 0, 0);
      return pen;
    };
    const width = this.scroll.clientWidth;
    this.pen = fit(this.plot, width, Math.max(1, this.scroll.clientHeight));
    this.axisPen = fit(this.axis, width, 24);
    this.overviewPen = fit(this.overview, width, 34);
    this.drawnOverview = null;
    this.draw();
  }

  draw() {
    if (!this.pen || !this.state.flight) return;
    const style = getComputedStyle(document.documentElement);
    const colors = {};
    this.color = (name) => (colors[name] ??= style.getPropertyValue("--" + name).trim());
    this.drawAxis();
    this.drawRows();
    this.drawOverview();
  }

  drawAxis() {
    const pen = this.axisPen, {from, to} = this.state.view;
    pen.clearRect(0, 0, this.scroll.clientWidth, 24);
    this.ticks = ticksOf(from, to, this.width);
    pen.font = "11px " + this.color("font");
    pen.fillStyle = this.color("quiet");
    pen.strokeStyle = this.color("edge");
    pen.textBaseline = "middle";
    for (const tick of this.ticks.ticks) {
      const x = Math.round(this.x(tick)) + 0.5;
      pen.beginPath();
      pen.moveTo(x, 16);
      pen.lineTo(x, 24);
      pen.stroke();
      pen.fillText(clockText(tick, this.ticks.step), Math.min(x + 4, this.scroll.clientWidth - 54), 11);
    }
    const x = this.x(this.state.cursor);
    pen.fillStyle = this.color("accent");
    if (x < this.labels - 1 || x > this.labels + this.width + 1) return this.pointToCursor(x < this.labels);
    pen.beginPath();
    pen.moveTo(x - 6, 12);
    pen.lineTo(x + 6, 12);
    pen.lineTo(x, 23);
    pen.fill();
  }

  /** A cursor out of sight: at the edge of the axis on its side, with its time. */
  pointToCursor(left) {
    const pen = this.axisPen, edge = left ? this.labels : this.labels + this.width, out = left ? -1 : 1;
    const text = clockText(this.state.cursor);
    const wide = pen.measureText(text).width + 22;
    pen.fillRect(left ? edge : edge - wide, 3, wide, 17);
    pen.fillStyle = this.color("paper");
    pen.beginPath();
    pen.moveTo(edge - out * 4, 11.5);
    pen.lineTo(edge - out * 11, 6.5);
    pen.lineTo(edge - out * 11, 16.5);
    pen.fill();
    pen.fillText(text, left ? edge + 16 : edge - wide + 6, 12);
  }

  drawRows() {
    const pen = this.pen, top = this.scroll.scrollTop, height = this.scroll.clientHeight, width = this.scroll.clientWidth;
    this.plot.style.transform = "translateY(" + top + "px)";
    pen.clearRect(0, 0, width, height);
    pen.save();
    pen.beginPath();
    pen.rect(this.labels, 0, this.width, height);
    pen.clip();
    pen.strokeStyle = this.color("edge");
    pen.globalAlpha = 0.6;
    for (const tick of this.ticks.ticks) {
      const x = Math.round(this.x(tick)) + 0.5;
      pen.beginPath();
      pen.moveTo(x, 0);
      pen.lineTo(x, height);
      pen.stroke();
    }
    pen.globalAlpha = 1;
    for (const row of this.shown) {
      if (row.top + row.height < top || row.top > top + height) continue;
      if (row.curve) this.drawCurve(row, row.top - top);
      else this.drawSpans(row, row.top - top);
      if (row.marks) this.drawMarks(row.marks, row.top - top + row.height / 2, height);
    }
    this.drawCursor(height);
    pen.restore();
  }

  drawCursor(height) {
    const x = Math.round(this.x(this.state.cursor)) + 0.5;
    this.pen.strokeStyle = this.color("accent");
    this.pen.lineWidth = 1.5;
    this.pen.beginPath();
    this.pen.moveTo(x, 0);
    this.pen.lineTo(x, height);
    this.pen.stroke();
    this.pen.lineWidth = 1;
  }

  /** Where in the flight something happens, and what part of it is seen. */
  drawOverview() {
    const pen = this.overviewPen, {flight, events, view} = this.state;
    const x = (time) => this.labels + (flight.end > 0 ? time / flight.end : 0) * this.width;
    pen.clearRect(0, 0, this.scroll.clientWidth, 34);
    pen.fillStyle = this.color("shade");
    pen.fillRect(0, 0, this.scroll.clientWidth, 34);
    pen.font = "11px " + this.color("font");
    pen.textBaseline = "middle";
    pen.fillStyle = this.color("quiet");
    pen.fillText(clockText(flight.end), 8, 17);
    for (const event of events) {
      const bad = event.severe;
      pen.fillStyle = this.color(bad ? "fault" : event.kind === "met" ? "good" : event.kind === "goal" ? "warn" : "quiet");
      pen.globalAlpha = bad ? 1 : 0.45;
      const high = bad ? 26 : event.kind === "goal" ? 18 : 12;
      pen.fillRect(x(event.time) - 0.75, 30 - high, 1.5, high);
    }
    pen.globalAlpha = 1;
    const left = Math.max(this.labels, x(view.from)), right = Math.min(this.labels + this.width, x(view.to));
    pen.globalAlpha = 0.12;
    pen.fillStyle = this.color("accent");
    pen.fillRect(left, 0, Math.max(2, right - left), 34);
    pen.globalAlpha = 1;
    pen.strokeStyle = this.color("accent");
    pen.strokeRect(left + 0.5, 0.5, Math.max(2, right - left - 1), 33);
    pen.beginPath();
    pen.moveTo(x(this.state.cursor), 0);
    pen.lineTo(x(this.state.cursor), 34);
    pen.stroke();
  }

  /** What each row says at the cursor, beside its name. */
  tell() {
    const time = this.state.cursor;
    for (const row of this.shown) {
      if (row.note) continue;
      const span = row.marks ? null : row.at(time);
      const share = span && span.share < 1 ? " " + Math.round(span.share * 100) + " %" : "";
      const said = row.marks ? "" : span ? span.text + (row.child && row.label.startsWith("belief") ? "" : share) : "\u2013";
      if (row.said === said) continue;
      row.said = said;
      row.valueElement.textContent = said;
      row.valueElement.title = said;
      row.valueElement.classList.toggle("fault", span?.tone === "fault");
      row.element.setAttribute("aria-label", row.label + ": " + (said === "\u2013" ? "nothing" : said));
    }
  }
}
