// SPDX-License-Identifier: MIT
// write_golden_messages.mjs FOLDER: writes one message of each type that robots/footage/messages/ decodes, with other
// libraries: NAME.cdr (ROS 2), NAME.pb (Foxglove, Protocol Buffers) and NAME.json (Foxglove, JSON). The values are those
// that golden_messages_test.cpp expects. Also writes logs of ROS 2 with the MCAP project's own writer: NAME.mcap, for
// mcap_log_test.cpp.
import rosDefinitions from "@foxglove/rosmsg-msgs-common";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import foxglove from "@foxglove/schemas/internal.js";
import zstd from "@foxglove/wasm-zstd";
import { McapWriter } from "@mcap/core";
import protobuf from "protobufjs";
import { writeFileSync } from "node:fs";

const folder = process.argv[2];
const { ros2humble } = rosDefinitions;

const sequence = (length, first = 1) => Array.from({ length }, (_, i) => first + i);
const stamp = { sec: 1700000000, nanosec: 123456789 };
const header = (frame_id) => ({ stamp, frame_id });
const translation = { x: 1.5, y: -2.25, z: 0.125 };
const rotation = { x: 0.5, y: -0.5, z: 0.5, w: 0.5 };
const pose = { position: translation, orientation: rotation };
const pixels = Uint8Array.from(sequence(2 * 14, 10)); // 4x2 pixels of rgb8, two bytes of padding behind each row
const file = Uint8Array.from([0xff, 0xd8, 0xff, 0xd9, 0x00]);
const calibration = { d: [-0.1, 0.02, 0, 0, 0], k: sequence(9, 100), r: [1, 0, 0, 0, 1, 0, 0, 0, 1], p: sequence(12, 200) };

// ROS 2
const ros = {
  image: ["sensor_msgs/Image", {
    header: header("camera_optical"), height: 2, width: 4, encoding: "rgb8", is_bigendian: 0, step: 14, data: pixels }],
  compressed_image: ["sensor_msgs/CompressedImage", { header: header("camera_optical"), format: "jpeg", data: file }],
  camera_info: ["sensor_msgs/CameraInfo", {
    header: header("camera_optical"), height: 480, width: 640, distortion_model: "plumb_bob", ...calibration,
    binning_x: 2, binning_y: 2, roi: { x_offset: 8, y_offset: 16, height: 240, width: 320, do_rectify: true } }],
  transforms: ["tf2_msgs/TFMessage", {
    transforms: [
      { header: header("odom"), child_frame_id: "base_link", transform: { translation, rotation } },
      { header: header("base_link"), child_frame_id: "camera", transform: { translation, rotation: { x: 0, y: 0, z: 0, w: 1 } } },
    ] }],
  pose_stamped: ["geometry_msgs/PoseStamped", { header: header("map"), pose }],
  pose_with_covariance_stamped: ["geometry_msgs/PoseWithCovarianceStamped", {
    header: header("map"), pose: { pose, covariance: sequence(36) } }],
  odometry: ["nav_msgs/Odometry", {
    header: header("odom"), child_frame_id: "base_footprint", pose: { pose, covariance: sequence(36) },
    twist: { twist: { linear: translation, angular: translation }, covariance: sequence(36) } }],
  imu: ["sensor_msgs/Imu", {
    header: header("imu"), orientation: rotation, orientation_covariance: sequence(9),
    angular_velocity: translation, angular_velocity_covariance: sequence(9),
    linear_acceleration: translation, linear_acceleration_covariance: sequence(9) }],
};
ros.imu_without_orientation = ["sensor_msgs/Imu", { ...ros.imu[1], orientation_covariance: [-1, ...sequence(8)] }];
const serialized = (type, message) => {
  const others = Object.values(ros2humble).filter((definition) => definition.name !== type);
  return new MessageWriter([{ definitions: ros2humble[type].definitions }, ...others]).writeMessage(message);
};
for (const [name, [type, message]] of Object.entries(ros))
  writeFileSync(`${folder}/${name}.cdr`, serialized(type, message));

// Logs: a transform, a calibration and an image, three times.
const writeLog = async (name, options) => {
  const parts = [];
  let size = 0n;
  const writable = {
    position: () => size,
    write: async (bytes) => {
      parts.push(Buffer.from(bytes));
      size += BigInt(bytes.byteLength);
    },
  };
  const writer = new McapWriter({ writable, ...options });
  await writer.start({ profile: "ros2", library: "golden" });
  const channels = {};
  for (const [topic, type] of [
    ["/tf", "tf2_msgs/TFMessage"], ["/camera/camera_info", "sensor_msgs/CameraInfo"], ["/camera/image_raw", "sensor_msgs/Image"]]) {
    const schemaId = await writer.registerSchema({
      name: type.replace("/", "/msg/"), encoding: "ros2msg", data: new Uint8Array() });
    const id = await writer.registerChannel({ schemaId, topic, messageEncoding: "cdr", metadata: new Map() });
    channels[topic] = { id, type, sequence: 0 };
  }
  const add = async (topic, nanoseconds, message) => {
    const { id, type, sequence } = channels[topic];
    channels[topic].sequence += 1;
    const time = 1700000000000000000n + BigInt(nanoseconds);
    const data = serialized(type, message);
    await writer.addMessage({ channelId: id, sequence, logTime: time, publishTime: time, data });
  };
  for (let i = 0; i < 3; ++i) {
    const at = (frame_id) => ({ stamp: { sec: stamp.sec + i, nanosec: 0 }, frame_id });
    const [, info] = ros.camera_info;
    const roi = { x_offset: 0, y_offset: 0, height: 0, width: 0, do_rectify: false };
    const turned = { translation: { x: i, y: 2, z: 0 }, rotation: { x: 0, y: 0, z: 0.6, w: 0.8 } };
    const mount = { translation: { x: 0, y: 0, z: 0.5 }, rotation: { x: -0.5, y: 0.5, z: -0.5, w: 0.5 } };
    await add("/camera/image_raw", i * 1e9 + 3e6, { ...ros.image[1], header: at("camera_optical") });
    await add("/camera/camera_info", i * 1e9 + 2e6, { ...info, header: at("camera_optical"), width: 4, height: 2, roi });
    await add("/tf", i * 1e9 + 1e6, { transforms: [
      { header: at("map"), child_frame_id: "base_link", transform: turned },
      { header: at("base_link"), child_frame_id: "camera_optical", transform: mount }] });
  }
  await writer.end();
  writeFileSync(`${folder}/${name}.mcap`, Buffer.concat(parts));
};
await zstd.isLoaded;
const compressChunk = (data) => ({ compression: "zstd", compressedData: zstd.compress(data) });
await writeLog("chunks_zstd", { chunkSize: 1500, compressChunk });
await writeLog("chunks_without_repeated_topics", { chunkSize: 1500, repeatSchemas: false, repeatChannels: false });
await writeLog("without_chunks", { useChunks: false });

// Foxglove
const root = new protobuf.Root();
for (const [name, schema] of Object.entries(foxglove.foxgloveMessageSchemas)) {
  if (schema.protoEquivalent !== undefined) continue;
  const enums = Object.values(foxglove.foxgloveEnumSchemas).filter((each) => each.parentSchemaName === name);
  protobuf.parse(foxglove.generateProto(schema, enums), root, { keepCase: true });
}
root.addJSON(protobuf.common.get("google/protobuf/timestamp.proto").nested);
root.addJSON(protobuf.common.get("google/protobuf/duration.proto").nested);
root.resolveAll();

const timestamp = { sec: stamp.sec, nsec: stamp.nanosec };
const { d, k, r, p } = calibration;
const transform = (parent_frame_id, child_frame_id) => ({ timestamp, parent_frame_id, child_frame_id, translation, rotation });
const messages = {
  raw_image: ["RawImage", {
    timestamp, frame_id: "camera_optical", width: 4, height: 2, encoding: "rgb8", step: 14, data: pixels }],
  compressed_image: ["CompressedImage", { timestamp, frame_id: "camera_optical", data: file, format: "jpeg" }],
  camera_calibration: ["CameraCalibration", {
    timestamp, frame_id: "camera_optical", width: 640, height: 480, distortion_model: "plumb_bob", D: d, K: k, R: r, P: p }],
  frame_transform: ["FrameTransform", transform("odom", "base_link")],
  frame_transforms: ["FrameTransforms", { transforms: [transform("odom", "base_link"), transform("base_link", "camera")] }],
  pose_in_frame: ["PoseInFrame", { timestamp, frame_id: "map", pose }],
};
const forProtobuf = (value) => {
  if (value instanceof Uint8Array || typeof value !== "object") return value;
  if (Array.isArray(value)) return value.map(forProtobuf);
  if ("nsec" in value) return { seconds: value.sec, nanos: value.nsec };
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, forProtobuf(each)]));
};
for (const [name, [type, message]] of Object.entries(messages)) {
  const protobufType = root.lookupType(`foxglove.${type}`);
  const fields = forProtobuf(message);
  const mistake = protobufType.verify(fields);
  if (mistake) throw new Error(`${type}: ${mistake}`);
  writeFileSync(`${folder}/${name}.pb`, protobufType.encode(protobufType.create(fields)).finish());
  const json = JSON.stringify(message, (_, value) =>
    value instanceof Uint8Array ? Buffer.from(value).toString("base64") : value);
  writeFileSync(`${folder}/${name}.json`, json);
}
