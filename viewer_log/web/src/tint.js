// Colours on the robot that say where it is in trouble: links about to touch each other, joints near the end of their range.

const kNearLimit = 3 * Math.PI / 180, kNearEnd = 0.01; // of a joint that turns [rad], of one that slides [m]
const kRed = 0xff2d2d, kOrange = 0xff9d1f, kViolet = 0xa855f7;

// Joints within 3 degrees or 10 mm of a limit, the nearest first: { name, link, left, share, words }, left in radians or metres (negative: beyond).
export function nearLimits(joints, q) {
  const found = [];
  joints.forEach((joint, i) => {
    const { lower, upper } = joint?.limit ?? {};
    if (!(upper > lower) || q[i] == null) return;
    const left = Math.min(q[i] - lower, upper - q[i]), slides = joint.jointType === 'prismatic';
    const share = left / (slides ? kNearEnd : kNearLimit);
    const words = slides ? `${(1000 * left).toFixed(1)} mm` : `${(left * 180 / Math.PI).toFixed(1)}°`;
    if (share < 1) found.push({ name: joint.name, link: joint, left, share, words });
  });
  return found.sort((a, b) => a.share - b.share);
}

export class Tint {
  constructor() { this.shown = new Map(); } // link or joint object -> colour

  // pairs as in a live message, limits from nearLimits.
  show(model, pairs, limits) {
    const wanted = new Map();
    for (const limit of limits) wanted.set(limit.link, kViolet);
    for (const pair of pairs) {
      if (!pair.level) continue; // only near, as it is in every posture
      for (const name of [pair.a, pair.b]) {
        const link = model.links[name];
        if (link && wanted.get(link) !== kRed) wanted.set(link, pair.level === 'touch' ? kRed : kOrange);
      }
    }
    for (const [part, color] of this.shown) if (wanted.get(part) !== color) this.paint(part, null);
    for (const [part, color] of wanted) if (this.shown.get(part) !== color) this.paint(part, color);
    this.shown = wanted;
  }

  // The part's own shapes only, not those of the links that hang from it.
  paint(part, color) {
    const visit = (object) => {
      if (object !== part && (object.isURDFJoint || object.isURDFLink) && !(part.isURDFJoint && object.parent === part)) return;
      if (object.isMesh && object.material.emissive) {
        object.material.emissive.set(color ?? 0);
        object.material.emissiveIntensity = color === null ? 1 : 0.55;
      }
      object.children.forEach(visit);
    };
    visit(part);
  }
}
