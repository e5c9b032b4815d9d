// Beeps while an alarm is new: the graver, the more often. Browsers want a click first.

const PERIODS = [0.7, 1.5, 5];  // [s] of critical, alarm, warning
const PITCHES = [988, 784, 523];  // [Hz]

export class Sound {
  constructor(button) {
    this.button = button;
    this.context = null;
    this.last = 0;
    button.addEventListener("click", () => {
      if (this.context) {
        this.context.close();
        this.context = null;
      } else {
        this.context = new AudioContext();
        this.beep(1);
      }
      button.textContent = this.context ? "Sound on" : "Sound off";
      button.setAttribute("aria-pressed", String(Boolean(this.context)));
    });
  }

  // priority: of the gravest new alarm, 0 to 2; null: none.
  update(priority) {
    const now = performance.now() / 1000;
    if (!this.context || priority === null || now - this.last < PERIODS[priority]) return;
    this.last = now;
    this.beep(priority);
  }

  beep(priority) {
    const tone = this.context.createOscillator(), volume = this.context.createGain(), begin = this.context.currentTime;
    tone.frequency.value = PITCHES[priority];
    volume.gain.setValueAtTime(0.0001, begin);
    volume.gain.exponentialRampToValueAtTime(0.25, begin + 0.02);
    volume.gain.exponentialRampToValueAtTime(0.0001, begin + 0.25);
    tone.connect(volume).connect(this.context.destination);
    tone.start(begin);
    tone.stop(begin + 0.3);
  }
}
