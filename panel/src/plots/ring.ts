/** Samples of several channels over time; the oldest are overwritten. Memory is constant. */
export class Ring {
  private readonly times: Float64Array;
  private readonly columns: Float64Array[];
  private first = 0;
  private count = 0;

  constructor(
    channels: number,
    private readonly capacity: number,
  ) {
    this.times = new Float64Array(capacity);
    this.columns = Array.from({ length: channels }, () => new Float64Array(capacity));
  }

  get length(): number {
    return this.count;
  }

  /** Time of the newest sample, or NaN. */
  get last(): number {
    return this.count === 0 ? NaN : this.time(this.count - 1);
  }

  /** A sample that is not newer than the last one is left out; missing values are NaN. */
  push(time: number, values: (number | null | undefined)[]): void {
    if (this.count > 0 && !(time > this.last)) return;
    const index = (this.first + this.count) % this.capacity;
    this.times[index] = time;
    this.columns.forEach((column, channel) => {
      column[index] = values[channel] ?? NaN;
    });
    if (this.count < this.capacity) ++this.count;
    else this.first = (this.first + 1) % this.capacity;
  }

  /**
   * Samples from `from` to `to`: times, then one array for each of `channels`. Of more than `most` samples every
   * n-th is taken.
   */
  window(from: number, to: number, channels: number[], most: number): { times: number[]; values: (number | null)[][] } {
    const begin = this.search((time) => time < from);
    const end = this.search((time) => time <= to);
    const stride = Math.max(1, Math.ceil((end - begin) / most));
    const times: number[] = [];
    const values: (number | null)[][] = channels.map(() => []);
    for (let i = begin - (begin % stride); i < end; i += stride) {
      if (i < begin) continue;
      const index = (this.first + i) % this.capacity;
      times.push(this.times[index] ?? 0);
      channels.forEach((channel, k) => {
        const value = this.columns[channel]?.[index];
        values[k]?.push(value === undefined || Number.isNaN(value) ? null : value);
      });
    }
    return { times, values };
  }

  private time(i: number): number {
    return this.times[(this.first + i) % this.capacity] ?? NaN;
  }

  /** Number of samples at the beginning for which `before` holds. */
  private search(before: (time: number) => boolean): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (before(this.time(middle))) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
