// Shows a glTF file by three.js as a viewer would, from the file's first camera, and sends the picture back.
//   view.html?model=URL&width=W&height=H
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

/// MOZ_lightmap: the loader's own hooks, as docs/baking.md shows them.
class Lightmaps {
  name = "MOZ_lightmap";
  constructor(parser) { this.parser = parser; }
  loadMaterial(index) {
    const map = this.parser.json.materials[index].extensions?.[this.name];
    return map ? this.withLightmap(index, map) : null;
  }
  async withLightmap(index, map) {
    const material = await this.parser.loadMaterial(index);
    await this.parser.assignTexture(material, "lightMap", map);
    material.lightMap.colorSpace = THREE.LinearSRGBColorSpace;
    material.lightMapIntensity = map.intensity;
    return material;
  }
}

async function picture({ model, width, height }) {
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(Number(width), Number(height));
  document.body.append(renderer.domElement);
  const loader = new GLTFLoader();
  loader.register((parser) => new Lightmaps(parser));
  const gltf = await loader.loadAsync(model);
  const camera = gltf.cameras[0];
  camera.aspect = Number(width) / Number(height);
  camera.updateProjectionMatrix();
  gltf.scene.updateMatrixWorld();
  renderer.render(gltf.scene, camera);
  return renderer.domElement.toDataURL("image/png");
}

const answer = await picture(Object.fromEntries(new URLSearchParams(location.search))).catch((e) => `failed: ${e.stack}`);
await fetch("/answer", { method: "POST", body: answer });
