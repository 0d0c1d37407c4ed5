import { WebGLRenderer, type PerspectiveCamera, type Scene } from 'three';

const POLL = 8; // ms between two looks whether a picture is finished
const SHORTEST_SOFTWARE = 120; // ms between two pictures that the processor draws
const PAUSE = 0.5; // after a picture, as a part of its time
const PAUSE_SOFTWARE = 2; // the processor has to serve the page and the run, too
const LONGEST_PAUSE = 400; // ms

/** Draws when something has changed, and leaves time for everything else between two pictures. */
export class Renderer {
  private readonly renderer: WebGLRenderer;
  private readonly context: WebGL2RenderingContext;
  private readonly software: boolean;
  private wanted = false;
  private busy = false;

  /** Throws if the browser has no WebGL. `draw` calls `render`. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly draw: (renderer: Renderer) => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'low-power' });
    this.renderer.shadowMap.enabled = false;
    this.context = this.renderer.getContext() as WebGL2RenderingContext;
    this.software = is_software(this.context);
    this.renderer.setPixelRatio(this.software ? 1 : Math.min(2, devicePixelRatio));
  }

  /** Asks for a picture. */
  ask(): void {
    this.wanted = true;
    if (this.busy) return;
    this.busy = true;
    requestAnimationFrame(() => this.make_picture());
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.canvas.dataset['size'] = `${width}x${height}`;
    this.ask();
  }

  render(world: Scene, camera: PerspectiveCamera): void {
    this.renderer.render(world, camera);
  }

  private make_picture(): void {
    this.wanted = false;
    const begin = performance.now();
    this.draw(this);
    const fence = this.context.fenceSync(this.context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.context.flush();
    this.await_picture(fence, begin);
  }

  private await_picture(fence: WebGLSync | null, begin: number): void {
    const { context } = this;
    const finished =
      !fence || context.isContextLost() || context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
    if (!finished) {
      setTimeout(() => this.await_picture(fence, begin), POLL);
      return;
    }
    context.deleteSync(fence);
    const took = performance.now() - begin;
    const pause = this.software ? Math.max(SHORTEST_SOFTWARE - took, PAUSE_SOFTWARE * took) : PAUSE * took;
    setTimeout(
      () => {
        this.busy = false;
        if (this.wanted) this.ask();
      },
      Math.min(pause, LONGEST_PAUSE),
    );
    this.canvas.dataset['took'] = took.toFixed(0);
  }
}

function is_software(context: WebGL2RenderingContext): boolean {
  const information = context.getExtension('WEBGL_debug_renderer_info');
  const name = information ? String(context.getParameter(information.UNMASKED_RENDERER_WEBGL)) : '';
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}
