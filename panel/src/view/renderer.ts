import { WebGLRenderer, type PerspectiveCamera, type Scene } from 'three';

const SHORTEST_SOFTWARE = 80; // ms between two pictures that the processor draws

/** Draws when something has changed, and not more often than this machine stands. */
export class Renderer {
  private readonly renderer: WebGLRenderer;
  private readonly software: boolean;
  private asked = false;
  private last = 0;

  /** Throws if the browser has no WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly draw_into: (renderer: Renderer) => void) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'low-power' });
    this.renderer.shadowMap.enabled = false;
    this.software = is_software(this.renderer.getContext());
    this.renderer.setPixelRatio(this.software ? 1 : Math.min(2, devicePixelRatio));
  }

  /** Asks for a picture. */
  ask(): void {
    if (this.asked) return;
    this.asked = true;
    const wait = this.software ? this.last + SHORTEST_SOFTWARE - performance.now() : 0;
    if (wait > 0) setTimeout(() => this.ask_frame(), wait);
    else this.ask_frame();
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.canvas.dataset['size'] = `${width}x${height}`;
    this.ask();
  }

  render(world: Scene, camera: PerspectiveCamera): void {
    this.renderer.render(world, camera);
  }

  private ask_frame(): void {
    requestAnimationFrame(() => {
      this.asked = false;
      this.last = performance.now();
      this.draw_into(this);
    });
  }
}

function is_software(context: WebGLRenderingContext | WebGL2RenderingContext): boolean {
  const information = context.getExtension('WEBGL_debug_renderer_info');
  const name = information ? String(context.getParameter(information.UNMASKED_RENDERER_WEBGL)) : '';
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}
