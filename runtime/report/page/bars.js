// Bars, their labels and marks: what is drawn of rows along an axis of time.

class Bars {
  get labels() {
    return this.scroll.clientWidth < 700 ? 150 : 250;
  }
  get width() {
    return Math.max(50, this.scroll.clientWidth - this.labels);
  }
  x(time) {
    const {from, to} = this.state.view;
    return this.labels + ((time - from) / (to - from)) * this.width;
  }
  timeAt(x) {
    const {from, to} = this.state.view;
    return from + ((x - this.labels) / this.width) * (to - from);
  }

  drawSpans(row, top) {
    const high = row.height - 7 - (row.under ? 4 : 0);
    this.drawnTo = -1;  // spans narrower than a pixel side by side are one
    for (const run of row.runs) {
      if (run.to < this.state.view.from || run.from > this.state.view.to) continue;
      let widest = null, most = -1;
      for (const span of run.spans) {
        if (span.to < this.state.view.from || span.from > this.state.view.to) continue;
        const wide = this.drawSpan(span, top + 3.5, high);
        if (wide > most) [widest, most] = [span, wide];
      }
      const start = Math.max(this.labels, this.x(run.from)), end = Math.min(this.labels + this.width, this.x(run.to));
      if (widest && end - start > 26) this.write(widest, start + 6, top + 3.5 + high / 2, end - 6);
    }
    if (row.under) this.drawTruth(row, top + row.height - 6.5);
  }

  /** Gives how wide the span is on the screen. */
  drawSpan(span, top, high) {
    const pen = this.pen;
    const left = Math.max(this.labels - 4, this.x(span.from));
    const right = Math.min(this.labels + this.width + 4, this.x(span.to));
    const wide = Math.max(right - left, span.tone === "rest" ? 0 : 3);
    if (left + wide < this.drawnTo + 0.5 && wide <= 3) return right - left;
    this.drawnTo = left + wide;
    pen.globalAlpha = span.title ? span.share : 0.16 + 0.84 * span.share;
    pen.fillStyle = this.color(span.tone);
    pen.beginPath();
    pen.roundRect(left, top, Math.max(wide - 0.5, 0.5), high, Math.min(3, wide / 2));
    pen.fill();
    pen.globalAlpha = 1;
    return right - left;
  }

  /** The text of a span between two places, shortened where it has to be. */
  write(span, x, y, end) {
    const pen = this.pen;
    pen.font = "11.5px " + this.color("font");
    pen.textBaseline = "middle";
    let text = span.text, wide = pen.measureText(text).width;
    while (wide > end - x) {
      const kept = Math.min(text.length - 2, Math.floor((text.length * (end - x)) / wide));
      if (kept < 3) return;
      text = text.slice(0, kept).trimEnd() + "\u2026";
      wide = pen.measureText(text).width;
    }
    const ink = {fault: "fault-ink", rest: "rest-ink", accent: "paper", warn: "paper"}[span.tone] ?? "m-ink";
    pen.fillStyle = this.color(span.share < 0.4 ? "ink" : ink);
    pen.fillText(text, x, y + 0.5);
  }

  /** A channel: each limit a line with what lies within shaded, and the samples as steps over them. */
  drawCurve(row, top) {
    const pen = this.pen, {low, high, edges, limits} = row.curve;
    const left = this.labels, right = this.labels + this.width;
    const y = (value) => top + row.height - 3 - ((Math.min(Math.max(value, low), high) - low) / (high - low)) * (row.height - 6);
    pen.font = "10.5px " + this.color("font");
    pen.textBaseline = "middle";
    for (const {from, to, text, tone} of limits) {
      const above = y(to ?? high), below = y(from ?? low);
      pen.globalAlpha = 0.35;
      pen.fillStyle = this.color(tone);
      pen.fillRect(left, above, this.width, Math.max(below - above, 1));
      pen.globalAlpha = 1;
      if (below - above < 10) continue;
      pen.fillStyle = this.color("quiet");
      pen.fillText(text, right - pen.measureText(text).width - 6, (above + below) / 2);
    }
    pen.strokeStyle = this.color("quiet");
    pen.setLineDash([4, 3]);
    pen.beginPath();
    for (const edge of edges) {
      pen.moveTo(left, Math.round(y(edge)) + 0.5);
      pen.lineTo(right, Math.round(y(edge)) + 0.5);
    }
    pen.stroke();
    pen.setLineDash([]);
    this.drawSamples(row, y);
  }

  drawSamples(row, y) {
    const pen = this.pen;
    const within = (time) => Math.min(Math.max(this.x(time), this.labels - 8), this.labels + this.width + 8);
    pen.strokeStyle = this.color("ink");
    pen.fillStyle = pen.strokeStyle;
    pen.lineWidth = 1.6;
    pen.beginPath();
    let open = false, dots = [];
    for (const span of row.spans) {
      if (typeof span.value !== "number") open = false;
      if (typeof span.value !== "number" || span.to < this.state.view.from || span.from > this.state.view.to) continue;
      const start = within(span.from), high = y(span.value);
      if (open) pen.lineTo(start, high);
      else pen.moveTo(start, high);
      pen.lineTo(within(span.to), high);
      open = true;
      dots.push([start, high]);
    }
    pen.stroke();
    pen.lineWidth = 1;
    if (dots.length * 6 > this.width) return;  // too dense to be told apart
    for (const [x, at] of dots) {
      pen.beginPath();
      pen.arc(x, at, 2.2, 0, 7);
      pen.fill();
    }
  }

  /** The truth as a thin line below the estimate: bright where they differ. */
  drawTruth(row, y) {
    const pen = this.pen;
    for (const span of row.under) {
      if (span.to < this.state.view.from || span.from > this.state.view.to) continue;
      const left = Math.max(this.labels - 4, this.x(span.from));
      const wide = Math.max(1.5, Math.min(this.labels + this.width + 4, this.x(span.to)) - left);
      pen.fillStyle = this.color(span.tone);
      pen.fillRect(left, y, wide, 3);
    }
  }

  drawMarks(marks, y, height) {
    const pen = this.pen;
    for (const mark of [...marks].sort((a, b) => a.severe - b.severe)) {
      const x = this.x(mark.time);
      if (x < this.labels - 8 || x > this.labels + this.width + 8) continue;
      const good = mark.kind === "met";
      pen.fillStyle = this.color(good ? "good" : mark.severe ? "fault" : "quiet");
      pen.strokeStyle = pen.fillStyle;
      if (mark.severe) {
        pen.globalAlpha = 0.35;
        pen.setLineDash([3, 3]);
        pen.beginPath();
        pen.moveTo(x, y);
        pen.lineTo(x, height);
        pen.stroke();
        pen.setLineDash([]);
        pen.globalAlpha = 1;
      }
      pen.beginPath();
      if (good) pen.arc(x, y, 4, 0, 7);
      else if (mark.kind === "forced") pen.roundRect(x - 4.5, y - 4.5, 9, 9, 2);
      else {
        pen.moveTo(x, y - 6.5);
        pen.lineTo(x + 6, y);
        pen.lineTo(x, y + 6.5);
        pen.lineTo(x - 6, y);
      }
      pen.fill();
    }
  }
}
