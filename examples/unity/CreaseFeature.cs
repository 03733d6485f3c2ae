// SPDX-License-Identifier: MIT
// Ambient occlusion as a ScriptableRendererFeature of Unity 6's Universal Render Pipeline. It was not run: no Unity was at hand.
//
//   crease emit preset:medium/reconstructed_normals --target hlsl --target-version 50 --name ao -o Assets/Crease
//
// Of each .hlsl make a compute shader beside it, such as Visibility.compute, and give them to the feature in the order of the passes:
//
//   #pragma kernel main
//   #define _crease_depth_sampler crease_point_clamp_sampler
//   #define _crease_input_sampler crease_point_clamp_sampler
//   #include "0_visibility.comp.hlsl"
//
// With the rendering path Forward it multiplies the picture; the scale of the picture and the depth texture must be on.
using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.Universal;

public sealed class CreaseFeature : ScriptableRendererFeature
{
    /// <summary>Of the manifest: the stem of a pass's images, and what it reads and writes.</summary>
    [Serializable]
    public struct PassOfManifest
    {
        public ComputeShader shader;
        public bool readsDepth;
        public GraphicsFormat writes; // R32G32_UInt between passes, R8_UNorm of the last
    }

    [SerializeField] PassOfManifest[] passes;
    [SerializeField] Material multiply; // a full-screen shader: Blend DstColor Zero, red of _BlitTexture
    [SerializeField, Min(0)] float radius = 0.5f;
    [SerializeField] float[] settings; // the members of uniform_block behind "frame", in order

    CreasePass pass;

    public override void Create() =>
        pass = new CreasePass(this) { renderPassEvent = RenderPassEvent.AfterRenderingOpaques };

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData data)
    {
        if (passes.Length > 0 && multiply != null)
            renderer.EnqueuePass(pass);
    }

    protected override void Dispose(bool disposing) => pass?.Dispose();

    sealed class CreasePass : ScriptableRenderPass, IDisposable
    {
        readonly CreaseFeature feature;
        GraphicsBuffer block;

        public CreasePass(CreaseFeature of)
        {
            feature = of;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        public void Dispose() => block?.Dispose();

        /// <summary>What crease::set_projection makes of a perspective matrix, then radius, frame and settings.</summary>
        float[] BlockOf(Camera camera, int width, int height)
        {
            // Depth as the device has it. Unity turns what it draws to textures, so that row 0 is the bottom one everywhere.
            Matrix4x4 m = GL.GetGPUProjectionMatrix(camera.projectionMatrix, false);
            float scale = 1 / m.m23, offset = m.m22 / m.m23; // 1 / depth is z * scale + offset
            float least = Mathf.Min(offset, scale + offset);
            float[] view =
            {
                2 / (width * m.m00), 2 / (height * m.m11), (m.m02 - 1) / m.m00, (m.m12 - 1) / m.m11,
                scale, offset, 0.999f * (least > 1e-15f ? 1 / least : 1e15f), 0,
                width, height, 1f / width, 1f / height,
                feature.radius, 0, // the frame as a whole number has the same bits
            };
            var all = new float[(view.Length + feature.settings.Length + 3) / 4 * 4];
            view.CopyTo(all, 0);
            feature.settings.CopyTo(all, view.Length);
            return all;
        }

        sealed class Data
        {
            public PassOfManifest how;
            public TextureHandle read, written;
            public GraphicsBuffer block;
            public int width, height;
        }

        public override void RecordRenderGraph(RenderGraph graph, ContextContainer frame)
        {
            var resources = frame.Get<UniversalResourceData>();
            var camera = frame.Get<UniversalCameraData>();
            int width = camera.cameraTargetDescriptor.width, height = camera.cameraTargetDescriptor.height;
            float[] values = BlockOf(camera.camera, width, height);
            if (block == null || block.count != values.Length)
            {
                block?.Dispose();
                block = new GraphicsBuffer(GraphicsBuffer.Target.Constant, values.Length, sizeof(float));
            }
            block.SetData(values);

            TextureHandle last = resources.cameraDepthTexture;
            for (int i = 0; i < feature.passes.Length; ++i)
            {
                using var builder = graph.AddComputePass<Data>("crease " + i, out var data);
                TextureHandle made = graph.CreateTexture(new TextureDesc(width, height)
                {
                    name = "crease " + i,
                    format = feature.passes[i].writes,
                    enableRandomWrite = true,
                });
                data.how = feature.passes[i];
                data.read = data.how.readsDepth ? resources.cameraDepthTexture : last;
                (data.written, data.block, data.width, data.height) = (made, block, width, height);
                builder.UseTexture(data.read);
                builder.UseTexture(made, AccessFlags.Write);
                builder.SetRenderFunc((Data d, ComputeGraphContext context) => Run(d, context.cmd));
                last = made;
            }
            graph.AddBlitPass(new RenderGraphUtils.BlitMaterialParameters(last, resources.activeColorTexture, feature.multiply, 0),
                              "crease multiplies");
        }

        static void Run(Data data, ComputeCommandBuffer commands)
        {
            ComputeShader shader = data.how.shader;
            int kernel = shader.FindKernel("main");
            shader.GetKernelThreadGroupSizes(kernel, out uint across, out uint down, out _);
            commands.SetComputeConstantBufferParam(shader, "crease_parameters", data.block, 0, data.block.count * sizeof(float));
            commands.SetComputeTextureParam(shader, kernel, data.how.readsDepth ? "crease_depth" : "crease_input", data.read);
            commands.SetComputeTextureParam(shader, kernel, "crease_output", data.written);
            commands.DispatchCompute(shader, kernel, (data.width + (int)across - 1) / (int)across,
                                     (data.height + (int)down - 1) / (int)down, 1);
        }
    }
}
