// Times as people read them, and the ticks of an axis.

/**
 * `4:30:44.5`; below a minute `12.5 s`, below a second `250 ms`. `step`: how fine it has to be; microseconds where nothing
 * is said.
 */
function clockText(time, step = 0) {
  const sign = time < 0 ? "-" : "";
  const grain = step > 0 && step < 1e-6 ? 1 : 1e3;
  const nano = Math.round((Math.abs(time) * 1e9) / grain) * grain;
  if (nano < 60e9) {
    if (nano > 0 && nano < 1e9 && step < 1) return sign + trimmed(nano / 1e6) + " ms";
    return sign + trimmed(nano / 1e9) + " s";
  }
  const hours = Math.floor(nano / 3600e9);
  const minutes = Math.floor(nano / 60e9) % 60;
  const seconds = (nano % 60e9) / 1e9;
  const text = trimmed(seconds);
  return sign + hours + ":" + String(minutes).padStart(2, "0") + ":" + (seconds < 10 ? "0" : "") + text;
}

/** At most nine decimals, no zeros at the end. */
function trimmed(number) {
  return String(Number(number.toFixed(9)));
}

function secondsText(time) {
  return trimmed(Math.round(time * 1e6) / 1e6) + " s";
}

const steps = [1e-9, 2e-9, 5e-9];
for (let scale = 1e-8; scale < 0.9; scale *= 10) steps.push(scale, 2 * scale, 5 * scale);
steps.push(1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, 86400);
for (let days = 2; days < 1e6; days *= 10) steps.push(days * 86400, days * 2.5 * 86400, days * 5 * 86400);

/** Times at whole steps within a span, some `room` pixels apart at least. */
function ticksOf(from, to, width, room = 96) {
  const wanted = ((to - from) / Math.max(width, 1)) * room;
  const step = steps.find((s) => s >= wanted) ?? steps[steps.length - 1];
  const ticks = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to && ticks.length < 200; ++k) ticks.push(k * step);
  return {step, ticks};
}
