# SPDX-License-Identifier: MIT
# Ambient occlusion as a CompositorEffect of Godot 4.3 and up, Forward+. It was not run: no Godot was at hand.
#
#   crease emit preset:medium/packed_normals --format spirv --name ao -o addons/crease
#
# It runs any effect of compute passes over one layer by that manifest alone.
@tool
class_name CreaseEffect
extends CompositorEffect

@export_dir var folder := "res://addons/crease"
@export_range(0.0, 10.0, 0.01, "or_greater", "suffix:m") var radius := 0.5

const FORMATS := {
	"r8_unorm": RenderingDevice.DATA_FORMAT_R8_UNORM,
	"rgba8_unorm": RenderingDevice.DATA_FORMAT_R8G8B8A8_UNORM,
	"r32_uint": RenderingDevice.DATA_FORMAT_R32_UINT,
	"rg32_uint": RenderingDevice.DATA_FORMAT_R32G32_UINT,
	"rgba32_uint": RenderingDevice.DATA_FORMAT_R32G32B32A32_UINT,
	"r32_float": RenderingDevice.DATA_FORMAT_R32_SFLOAT,
	"rgba16_float": RenderingDevice.DATA_FORMAT_R16G16B16A16_SFLOAT,
}

# The picture times visibility; both images have its size.
const MULTIPLY := "#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba16f) uniform image2D colour;
layout(set = 0, binding = 1) uniform sampler2D visibility;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colour))))
        return;
    vec4 seen = imageLoad(colour, pixel);
    imageStore(colour, pixel, vec4(seen.rgb * texelFetch(visibility, pixel, 0).r, seen.a));
}"

var device: RenderingDevice
var manifest: Dictionary
var pipelines: Array[RID] = []
var shaders: Array[RID] = []
var images := {}
var block: RID
var sampler: RID
var size := Vector2i.ZERO


func _init() -> void:
	effect_callback_type = EFFECT_CALLBACK_TYPE_POST_OPAQUE
	access_resolved_color = true
	access_resolved_depth = true
	needs_normal_roughness = true


func _notification(what: int) -> void:
	if what != NOTIFICATION_PREDELETE or device == null:
		return
	var owned: Array = shaders + images.values() + [block, sampler] # pipelines go with their shaders
	for each: RID in owned:
		if each.is_valid():
			device.free_rid(each)


func _prepare() -> void:
	device = RenderingServer.get_rendering_device()
	manifest = JSON.parse_string(FileAccess.get_file_as_string(folder + "/ao.json"))
	for each: Dictionary in manifest.passes:
		var words := RDShaderSPIRV.new()
		words.bytecode_compute = FileAccess.get_file_as_bytes(folder + "/" + each.shaders[0].file)
		_add(words)
	var source := RDShaderSource.new()
	source.source_compute = MULTIPLY
	_add(device.shader_compile_spirv_from_source(source))
	block = device.uniform_buffer_create(int(manifest.uniform_block.size))
	sampler = device.sampler_create(RDSamplerState.new()) # nearest, clamped to the edge


func _add(words: RDShaderSPIRV) -> void:
	shaders.append(device.shader_create_from_spirv(words))
	pipelines.append(device.compute_pipeline_create(shaders.back()))


func _size_of(extent: Dictionary) -> Vector2i:
	if extent.has("width"):
		return Vector2i(int(extent.width), int(extent.height))
	var divisor := int(extent.divisor)
	return (size + Vector2i.ONE * (divisor - 1)) / divisor


func _resize(to: Vector2i) -> void:
	size = to
	for each: RID in images.values():
		device.free_rid(each)
	images.clear()
	for each: Dictionary in manifest.resources:
		if each.kind != "image" or each.lifetime == "input":
			continue
		var format := RDTextureFormat.new()
		format.format = FORMATS[each.format]
		var sides := _size_of(each.size)
		format.width = sides.x
		format.height = sides.y
		format.usage_bits = (RenderingDevice.TEXTURE_USAGE_STORAGE_BIT | RenderingDevice.TEXTURE_USAGE_SAMPLING_BIT
				| RenderingDevice.TEXTURE_USAGE_CAN_UPDATE_BIT)
		var data: Array[PackedByteArray] = []
		if each.has("texels"):
			data.append(FileAccess.get_file_as_bytes(folder + "/" + each.texels))
		images[each.name] = device.texture_create(format, RDTextureView.new(), data)


# What crease::set_projection makes of a perspective matrix whose depth is in [0, 1] and whose first row is the top one.
func _view_of(m: Projection) -> Dictionary:
	var scale := 1.0 / m[3].z
	var offset := m[2].z / m[3].z
	var nearest := minf(offset, scale + offset) # 1 / depth at the far plane
	return {
		"views[0].from_texel": [2.0 / (size.x * m[0].x), 2.0 / (size.y * m[1].y), (m[2].x - 1.0) / m[0].x, (m[2].y - 1.0) / m[1].y],
		"views[0].depth_unpack": [scale, offset],
		"views[0].far_depth": [0.999 * (1.0 / nearest if nearest > 1e-15 else 1e15)],
		"views[0].guard": [0.0],
		"views[0].resolution": [size.x, size.y],
		"views[0].texel_size": [1.0 / size.x, 1.0 / size.y],
		"radius": [radius],
	}


func _write_block(values: Dictionary) -> void:
	var bytes := PackedByteArray()
	bytes.resize(int(manifest.uniform_block.size))
	for member: Dictionary in manifest.uniform_block.members:
		var numbers: Array = values.get(member.name, [member.get("default", 0.0)])
		for i in numbers.size():
			if member.type != "uint": # the frame stays 0
				bytes.encode_float(int(member.offset) + 4 * i, numbers[i])
	device.buffer_update(block, 0, bytes.size(), bytes)


func _uniform(slot: int, type: int, ids: Array) -> RDUniform:
	var made := RDUniform.new()
	made.binding = slot
	made.uniform_type = type
	for id: RID in ids:
		made.add_id(id)
	return made


func _uniform_of(binding: Dictionary) -> RDUniform:
	var slot := int(binding.slot)
	match binding.access:
		"uniform":
			return _uniform(slot, RenderingDevice.UNIFORM_TYPE_UNIFORM_BUFFER, [block])
		"sample":
			return _uniform(slot, RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE, [sampler, images[binding.resource]])
		_:
			return _uniform(slot, RenderingDevice.UNIFORM_TYPE_IMAGE, [images[binding.resource]])


func _dispatch(which: int, uniforms: Array, group: Vector2i, sides: Vector2i) -> void:
	var bound := UniformSetCacheRD.get_cache(shaders[which], 0, uniforms)
	var list := device.compute_list_begin()
	device.compute_list_bind_compute_pipeline(list, pipelines[which])
	device.compute_list_bind_uniform_set(list, bound, 0)
	device.compute_list_dispatch(list, (sides.x + group.x - 1) / group.x, (sides.y + group.y - 1) / group.y, 1)
	device.compute_list_end()


func _render_callback(_type: int, data: RenderData) -> void:
	var buffers := data.get_render_scene_buffers() as RenderSceneBuffersRD
	var scene := data.get_render_scene_data() as RenderSceneDataRD
	if buffers == null or scene == null or buffers.get_internal_size() == Vector2i.ZERO:
		return
	if device == null:
		_prepare()
	if buffers.get_internal_size() != size:
		_resize(buffers.get_internal_size())
	for view in buffers.get_view_count():
		images["depth"] = buffers.get_depth_layer(view)
		images["normal"] = buffers.get_texture_slice("forward_clustered", "normal_roughness", view, 0, 1, 1)
		# Godot gives the matrix before it turns y, reverses depth and brings it to [0, 1].
		_write_block(_view_of(Projection.create_depth_correction(true) * scene.get_view_projection(view)))
		for i in manifest.passes.size():
			var each: Dictionary = manifest.passes[i]
			var group := Vector2i(int(each.workgroup[0]), int(each.workgroup[1]))
			_dispatch(i, each.bindings.map(_uniform_of), group, _size_of(each.size))
		var uniforms := [
			_uniform(0, RenderingDevice.UNIFORM_TYPE_IMAGE, [buffers.get_color_layer(view)]),
			_uniform(1, RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE, [sampler, images["visibility"]]),
		]
		_dispatch(shaders.size() - 1, uniforms, Vector2i(8, 8), size)
		images.erase("depth") # these are Godot's
		images.erase("normal")
