#include "projects.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "text.hpp"

namespace rotconv {
namespace {

// name, other names; SPECs, the names of the numbers; reference axes, body axes; source; remark. See Project.
// clang-format off
constexpr auto project_table = std::to_array<Project>({
    // the presets, up to opk
    {"scipy", "", "quat:xyzw as_quat; rotvec as_rotvec; dcm as_matrix; mrp as_mrp", "", "", "", "scipy.spatial.transform.Rotation", "the letters of its sequences are those of euler:SEQ"},
    {"ros", "ros2 tf tf2 moveit geometry-msgs geometry-msgs/quaternion", "quat:xyzw geometry_msgs/Quaternion; rpy setRPY, getRPY; euler:YXZ setEuler of tf, yaw pitch roll", "", "enu", "flu", "ROS geometry_msgs/Quaternion", "axes by REP 103; a quaternion that was not set is 0 0 0 0 in ROS 1, which is an error here, and the identity in ROS 2"},
    {"tum", "evo", "quat:xyzw columns 5-8 of a trajectory", "", "", "", "TUM RGB-D trajectory files", ""},
    {"matlab", "", "dcm:passive Aerospace Toolbox; dcm Robotics System Toolbox; quat both; euler:ZYX both, by default", "", "", "", "Aerospace Toolbox", "rotmat of a quaternion is dcm:passive for 'frame', dcm for 'point'"},
    {"basilisk", "schaub bn", "dcm:passive [BN]; quat beta0 first; mrp; euler:ZYX 321, yaw pitch roll", "", "", "", "Basilisk; Schaub and Junkins, [BN]", "RigidBodyKinematics.py"},
    {"spice", "naif spiceypy cspice", "dcm:passive C-matrix; quat:passive m2q", "", "", "", "SPICE C-matrices, reference to body", "m2eul(r, 3, 2, 1) gives the numbers of euler:XYZ in reverse order: those of euler:zyx, except at gimbal lock"},
    {"bunge", "", "euler:ZXZ phi1 Phi phi2; dcm:passive the matrix g; quat:passive", "phi1 Phi phi2", "", "", "materials science, P = +1; R takes crystal to sample", ""},
    {"baruh", "", "dcm:passive; quat:xyzw e4 is the scalar", "", "", "", "Baruh, Analytical Dynamics, 1999", ""},
    {"trawny", "", "dcm:passive; quat:xyzw", "", "", "", "Trawny and Roumeliotis 2005, the JPL quaternion", ""},
    {"jpl", "", "dcm:passive; quat:xyzw", "", "", "", "the JPL quaternion, as trawny", ""},
    {"stuelpnagel", "", "dcm:passive; quat:passive; cayley:passive", "", "", "", "Stuelpnagel, SIAM Review 6(4), 1964", ""},
    {"px4", "ulog", "quat q[0] ... q[3] of vehicle_attitude; rpy Eulerf, phi theta psi", "", "ned", "frd", "PX4, msg/VehicleAttitude.msg: FRD body to NED", ""},
    {"kitti", "", "dcm odometry: columns 1-3,5-7,9-11; rpy oxts: columns 4-6, reference axes enu, body axes flu", "", "rdf", "rdf", "KITTI odometry devkit, readme.txt: left camera poses", ""},
    {"euroc", "asl", "quat columns 5-8 of the ground truth, q_RS_w q_RS_x q_RS_y q_RS_z", "", "", "", "EuRoC, header of the ground truth: q_RS", ""},
    {"gtsam", "", "quat Rot3::Quaternion; rpy RzRyRx, rpy, xyz; euler:ZYX Ypr, ypr; rotvec Expmap", "", "", "", "GTSAM, gtsam/geometry/Rot3.h", ""},
    {"ceres", "", "quat; rotvec angle-axis; dcm:col AngleAxisToRotationMatrix; rpy:deg EulerAnglesToRotationMatrix", "", "", "", "Ceres, ceres/rotation.h", "QuaternionToRotation gives dcm"},
    {"drake", "", "rpy RollPitchYaw; quat", "", "", "", "Drake, math/roll_pitch_yaw.h", ""},
    {"blender", "mathutils", "quat; rpy order XYZ, which is about fixed axes; dcm", "", "", "", "Blender, mathutils", "camera axes are rub; angles are stored x y z for any order: select the columns in the order of the letters, which are lower case here"},
    {"mujoco", "mjcf", "quat; euler:XYZ:deg eulerseq xyz, which is about the body axes; axis-angle:deg axisangle; 6d xyaxes", "", "", "", "MuJoCo, doc/programming/simulation.rst", "the letters of eulerseq are in the other case here; without :deg if compiler/angle is radian"},
    {"colmap", "", "quat:passive images.txt", "", "", "rdf", "COLMAP, doc/format.rst: world to camera", ""},
    {"opk", "arcgis pix4d-opk metashape-opk omega-phi-kappa", "euler:XYZ:deg", "omega phi kappa", "enu", "rub", "photogrammetry, omega phi kappa: image to ground", "OpenSfM, opensfm/geometry.py; euler:opk is in radians"},
    // angles that have a name of their own
    {"ypr", "yawpitchroll", "euler:ZYX", "yaw pitch roll", "", "", "aerospace, sequence 321", "the numbers of rpy in reverse order"},
    // robots
    {"kuka", "krl", "euler:ZYX:deg", "A B C", "", "", "Basler, pose_format_kuka", ""},
    {"fanuc", "wpr", "rpy:deg", "W P R", "", "", "Basler, pose_format_fanuc", ""},
    {"abb", "rapid robtarget", "quat", "q1 q2 q3 q4", "", "", "Basler, pose_format_abb", "Euler angles: euler:ZYX:deg (z y x), RobotStudio's rx ry rz rpy:deg"},
    {"staubli", "val3", "euler:XYZ:deg", "rx ry rz", "", "", "Mech-Mind, Euler angles; RoboDK, robomath.py", ""},
    {"kawasaki", "oat", "euler:ZYZ:deg", "O A T", "", "", "Basler, pose_format_kawasaki", ""},
    {"yaskawa", "motoman", "rpy:deg", "Rx Ry Rz", "", "", "Basler, pose_format_yaskawa", ""},
    {"mitsubishi", "melfa", "rpy:deg", "A B C", "", "", "Basler, pose_format_mitsubishi", "A is about x, where KUKA's is about z"},
    {"nachi", "", "euler:ZYX:deg", "", "", "", "Mech-Mind, Euler angles", "the angle about z comes first"},
    {"epson", "spel", "euler:ZYX:deg", "", "", "", "Mech-Mind, Euler angles", "the angle about z comes first; no source found for the letters U V W"},
    {"denso", "", "rpy:deg", "RX RY RZ", "", "", "Mech-Mind, Euler angles; Denso RC8 manual", ""},
    {"dobot", "", "rpy:deg", "Rx Ry Rz", "", "", "Mech-Mind, Euler angles", "robots with six axes"},
    {"comau", "pdl2", "euler:ZYZ:deg", "", "", "", "Mech-Mind, Euler angles; RoboDK, robomath.py", "no source found for the letters A E R"},
    {"doosan", "", "euler:ZYZ:deg", "A B C", "", "", "Vathos, rotations; Mech-Mind, Euler angles", ""},
    {"adept", "omron-adept v+", "euler:ZYZ:deg", "yaw pitch roll", "", "", "V+ Language User's Guide", ""},
    {"techman", "tm omron-tm", "rpy:deg", "Rx Ry Rz", "", "", "Mech-Mind, Euler angles; RoboDK, robomath.py", ""},
    {"ufactory", "xarm lite6", "rpy:deg", "roll pitch yaw", "", "", "xArm and Lite 6 user manual", "its axis-angle is rotvec:deg"},
    {"jaka", "", "rpy", "rx ry rz", "", "", "JAKA SDK, rpy_to_rot_matrix", "radians, as in the SDK; in degrees: rpy:deg"},
    {"mecademic", "meca500", "euler:XYZ:deg", "alpha beta gamma", "", "", "RoboDK, robomath.py; Mecademic, space orientation and Euler angles", ""},
    {"robodk", "", "rpy:deg xyzrpw; euler:XYZ:deg Pose; euler:XYZ Pose_2_TxyzRxyz; quat pose_2_quaternion", "", "", "", "RoboDK, robomath.py", ""},
    {"ur", "universal-robots urscript", "rotvec", "rx ry rz", "", "", "Basler, pose_format_ur", ""},
    {"franka", "libfranka panda", "dcm:col", "", "", "", "libfranka, franka/control_types.h", "O_T_EE: columns 1-3,5-7,9-11; Measure Pose of the Desk: rpy:deg"},
    {"viam", "", "rpy euler_angles, roll pitch yaw; quat; axis-angle axis_angles: th is the angle", "", "", "", "Viam rdk, spatialmath", "an orientation vector is no SPEC: R = Rz(atan2(y, x)) Ry(acos z) Rz(th)"},
    {"halcon", "", "euler:XYZ:deg gba, halcon-gba; rpy:deg abg, halcon-abg; cayley rodriguez, halcon-rodriguez", "", "", "", "MVTec HALCON, create_pose", ""},
    {"halcon-gba", "gba", "euler:XYZ:deg", "RotX RotY RotZ", "", "", "MVTec HALCON, create_pose", ""},
    {"halcon-abg", "abg", "rpy:deg", "RotX RotY RotZ", "", "", "MVTec HALCON, create_pose", ""},
    {"halcon-rodriguez", "rodriguez", "cayley", "RotX RotY RotZ", "", "", "MVTec HALCON, create_pose", ""},
    // simulation, graphics and libraries
    {"usd", "openusd gfquat", "quat", "w x y z", "", "", "OpenUSD, GfQuatf(real, i, j, k); usdGeom/xformOp.cpp", "a GfMatrix4d is for row vectors: its rotation is dcm:passive; rotateXYZ is rpy:deg"},
    {"openxr", "", "quat:xyzw", "w x y z", "rub", "rub", "OpenXR specification, XrQuaternionf; Coordinate System", ""},
    {"dotnet", "system.numerics csharp", "quat:xyzw Quaternion; euler:YXZ yaw, pitch, roll: CreateFromYawPitchRoll; dcm:passive Matrix4x4, for row vectors", "", "", "", ".NET, System.Numerics.Quaternion", ""},
    {"gl-matrix", "", "quat:xyzw; rpy:deg fromEuler, order zyx; dcm:col mat3", "", "", "", "glMatrix, src/quat.js", ""},
    {"sophus", "", "quat:xyzw data(); rotvec log()", "", "", "", "Sophus, so3.hpp", ""},
    {"manif", "", "quat:xyzw coeffs(); rotvec log()", "", "", "", "manif, SO3_base.h", ""},
    {"pinocchio", "xyzquat", "quat:xyzw free flyer; rotvec log3; rpy rpyToMatrix", "", "", "", "Pinocchio, joint-free-flyer.hpp, math/rpy.hpp", ""},
    {"carla", "", "euler:Z-Y-X:deg yaw, pitch, roll: carla.Rotation with --columns 2,1,3", "", "fru", "fru", "CARLA, Python API, carla.Rotation", "left-handed, as unreal"},
    {"airsim", "", "quat:xyzw Quaternionr; quat Q_W Q_X Q_Y Q_Z of airsim_rec.txt; rpy to_eularian_angles pitch, roll, yaw: with --columns 2,1,3", "", "ned", "frd", "AirSim, docs/apis.md, PythonClient/airsim/utils.py", ""},
    {"tartanair", "", "quat:xyzw", "", "ned", "frd", "TartanAir, tartanair_tools, data_type.md", "columns 4-7"},
    {"urdf", "xacro", "rpy", "r p y", "", "", "urdfdom_headers, urdf_model/pose.h", ""},
    {"sdf", "gazebo gz-math", "rpy", "", "", "", "gz-math, Quaternion.hh", "a pose: columns 4-6"},
    {"unity", "unity3d", "quat:xyzw Quaternion; euler:YXZ:deg eulerAngles x y z: with --columns 2,1,3", "", "ruf", "ruf", "Unity manual, Quaternion.Euler", "left-handed; to ROS's axes: --reference-axes ruf:flu --body-axes ruf:flu"},
    {"unreal", "unrealengine ue ue4 ue5 frotator fquat", "quat:xyzw FQuat; euler:Z-Y-X:deg yaw, pitch, roll: FRotator with --columns 2,1,3", "", "fru", "fru", "Unreal Engine, FRotator::Quaternion", "left-handed; to ROS's axes: --reference-axes fru:flu --body-axes fru:flu"},
    {"godot", "", "quat:xyzw; euler:YXZ rotation x y z: with --columns 2,1,3", "", "", "", "Godot, core/math/basis.h", "camera axes are rub"},
    {"three.js", "threejs three", "quat:xyzw; euler:XYZ order XYZ, about the body axes; dcm:col elements", "", "", "", "three.js, src/math/Euler.js", "angles are stored x y z for any order: select the columns in the order of the letters"},
    {"gltf", "", "quat:xyzw", "w x y z", "", "", "glTF 2.0 specification", "a node's matrix: dcm:col --columns 1-3,5-7,9-11"},
    {"bvh", "biovision", "euler:ZXY:deg", "Zrotation Xrotation Yrotation", "", "", "University of Wisconsin, BVH", "where CHANNELS has another order: that order in upper case, euler:XYZ:deg"},
    {"glm", "opengl gl", "quat; rpy eulerAngles: pitch, yaw and roll are about x, y and z; dcm:col matrices", "", "", "", "GLM, gtc/quaternion.inl", ""},
    {"directx", "directxmath d3d xna", "quat:xyzw XMFLOAT4; euler:YXZ yaw, pitch, roll; dcm:passive matrices, for row vectors", "", "", "", "DirectXMath, XMMatrixRotationQuaternion", "left-handed as a rule: the numbers are read by the same formulas"},
    {"openvr", "steamvr", "quat HmdQuaternion_t; dcm HmdMatrix34_t: columns 1-3,5-7,9-11", "", "", "rub", "OpenVR, openvr.h", ""},
    {"eigen", "", "quat constructor; quat:xyzw coeffs(); euler:ZYX eulerAngles(2, 1, 0); dcm:col data()", "", "", "", "Eigen, Geometry/Quaternion.h", ""},
    {"pybullet", "bullet", "quat:xyzw; rpy getQuaternionFromEuler", "", "", "", "PyBullet quickstart guide", ""},
    {"isaac", "isaac-sim isaac-lab isaac-gym omniverse", "quat Isaac Sim Core, USD; quat:xyzw PhysX, Isaac Gym, Isaac Lab 3", "", "", "", "Isaac Sim, conventions", "camera axes are rub"},
    {"ompl", "", "quat:xyzw", "w x y z", "", "", "OMPL, SO3StateSpace.h", ""},
    {"pytorch3d", "", "quat; euler:XYZ upper case, about the body axes; 6d:passive rotation_6d, the first two rows", "", "", "", "pytorch3d, rotation_conversions.py", ""},
    {"transforms3d", "trimesh", "quat; rpy sxyz; euler:ZYX rzyx", "", "", "", "transforms3d, euler.py; trimesh, transformations.py", ""},
    {"pytransform3d", "", "quat; axis-angle; rotvec compact axis-angle", "", "", "", "pytransform3d, rotations", ""},
    {"orekit", "hipparchus", "quat; dcm:passive getMatrix", "", "", "", "Hipparchus, Rotation.java", ""},
    // cameras and vehicles
    {"bundler", "", "dcm:passive", "", "", "rub", "Bundler v0.4 user's manual", "R takes the world's axes to the camera's"},
    {"openmvg", "", "dcm:passive", "", "", "rdf", "openMVG, geometry/pose3.hpp", "the rotation of an extrinsic, world to camera"},
    {"meshroom", "alicevision", "dcm", "", "", "rdf", "AliceVision, sfmDataIO/jsonIO.hpp, geometry/Pose3.hpp", "rotation of .sfm is world to camera column by column: camera to world row by row"},
    {"opencv", "cv cv2 rvec solvepnp aruco", "rotvec rvec, object to camera; rotvec:passive the camera's attitude in the world", "", "", "rdf", "opencv2/calib3d.hpp; answers.opencv.org 64320", "to OpenGL's camera: --body-axes rdf:rub"},
    {"arkit", "arcamera", "dcm:col transform: columns 1-3,5-7,9-11; quat:xyzw vector of simd_quatf", "", "", "rub", "ARKit, ARCamera.transform", ""},
    {"opensfm", "odm webodm", "rotvec:passive", "", "enu", "rdf", "OpenSfM, doc/source/geometry.rst", ""},
    {"nerfstudio", "nerf instant-ngp ngp transforms.json", "dcm", "", "", "rub", "nerfstudio, data_conventions.md", "transform_matrix: columns 1-3,5-7,9-11"},
    {"kalibr", "T_cam_imu", "dcm", "", "rdf", "", "Kalibr, IccUtil.py; issue 751", "T_cam_imu takes the IMU's axes to the camera's; a 4x4: columns 1-3,5-7,9-11; its quaternions are quat:xyzw:passive, also those of exported poses, whose header calls x y z w by q_RS_w q_RS_x q_RS_y q_RS_z: --columns 5-8"},
    {"pix4d", "", "opk omega phi kappa; euler:ZYX:deg yaw pitch roll, reference axes ned, body axes frd, 0 0 0 looks down", "", "", "", "Pix4D, Yaw, Pitch, Roll and Omega, Phi, Kappa", "yaw pitch roll to omega phi kappa: --reference-axes ned:enu --body-axes frd:rfu"},
    {"metashape", "agisoft photoscan", "opk omega phi kappa; euler:-ZXY:deg yaw pitch roll", "", "enu", "rub", "agisoft.com/forum, topic 12200; ODM, opendm/photo.py", ""},
    {"realitycapture", "realityscan", "dcm:passive xcr:Rotation, body axes rdf; euler:ZYX:deg yaw pitch roll, reference axes ned, body axes frd, 0 0 0 looks down; opk omega phi kappa", "", "", "", "RealityScan, camera models and coordinate systems; forums.unrealengine.com 682588", "yaw pitch roll to xcr:Rotation: --reference-axes ned:enu --body-axes frd:rbd"},
    {"g2o", "", "quat:xyzw", "", "", "", "g2o, isometry3d_mappings.h", "VERTEX_SE3:QUAT: columns 6-9"},
    {"waymo", "", "rpy", "roll pitch yaw", "", "", "Waymo Open Dataset, dataset.proto", ""},
    {"nuscenes", "nuimages", "quat", "w x y z", "", "", "nuScenes, schema_nuscenes.md", ""},
    {"mavlink", "ATTITUDE_QUATERNION", "quat", "q1 q2 q3 q4", "ned", "frd", "MAVLink, common.xml", "ATTITUDE is rpy; MOUNT_ORIENTATION mixes frames"},
    {"ardupilot", "", "rpy:deg ATT, Roll Pitch Yaw; quat Q1 Q2 Q3 Q4", "", "ned", "frd", "ArduPilot, AP_Math/quaternion.cpp", ""},
    {"betaflight", "", "euler:-ZYX:deg yaw, pitch, roll: attitude with --columns 3,2,1", "", "nwu", "flu", "Betaflight, flight/imu.c, blackbox.c", "attitude is in tenths of a degree: divide by 10 first"},
    {"dji", "", "rpy:deg flight: by name, as XMP has roll, yaw, pitch; quat q0 q1 q2 q3 of the Onboard SDK", "", "ned", "frd", "DJI Onboard SDK, dji_telemetry.hpp, TOPIC_QUATERNION", "no source found for the sequence of the gimbal's angles: rpy:deg is often meant"},
    {"vectornav", "vn-100 vn-200", "euler:ZYX:deg", "yaw pitch roll", "ned", "frd", "VectorNav VN-100 user manual", "its quaternion is quat:xyzw"},
    {"sbg", "sbgecom", "rpy EKF_EULER; quat EKF_QUAT", "", "ned", "frd", "sbgECom, sbgEComLogEkf.h", ""},
    // astronautics
    {"chandra", "ra-dec-roll radec", "euler:Z-YX:deg", "ra dec roll", "", "", "sot, Quaternion.py", "from 0 to 360 with :positive; its q is quat:xyzw"},
    {"ccsds", "aem apm", "quat:xyzw LAST, and all of 504.0-B-2; quat FIRST; euler:ZYX:deg sequence 321", "", "", "", "CCSDS 504.0-B; Orekit, AttitudeType.java", "for A the reference, B the body and A2B; otherwise the quaternions are :passive"},
    {"stk", "", "quat:xyzw AttitudeTimeQuaternions; quat AttitudeTimeQuatScalarFirst; dcm:passive AttitudeTimeDCM", "", "", "", "STK, IAgEntityAttitudeQuaternion", ""},
    {"gmat", "", "quat:xyzw; dcm:passive; euler:ZYX:deg sequence 321; mrp", "", "", "", "GMAT, AttitudeConversionUtility.cpp", ""},
    {"wertz", "", "quat:xyzw; dcm:passive; euler:ZXZ 313", "", "", "", "Wertz, Spacecraft Attitude Determination and Control", ""},
    {"diebel", "", "quat; dcm:passive; rpy sequence (1, 2, 3)", "", "", "", "Diebel, Representing Attitude, 2006", "its matrices take reference to body axes"},
    {"hughes", "", "", "", "", "", "", "no source found; often meant, as in wertz: dcm:passive and quat:xyzw"},
    // materials and microscopy
    {"mtex", "", "euler:ZXZ; quat a b c d; dcm", "", "", "", "MTEX, MTEXvsBungeConvention.m", "Bunge's g is dcm:passive"},
    {"dream3d", "ebsdlib", "euler:ZXZ; quat:xyzw:passive; dcm:passive; axis-angle:passive", "", "", "", "EbsdLib, OrientationTransformation.hpp", ""},
    {"damask", "", "euler:ZXZ; quat; axis-angle; dcm:passive", "", "", "", "DAMASK, python/damask/_rotation.py", "P = -1: only its matrices are passive"},
    {"ctf", "oxford hkl", "euler:ZXZ:deg", "Euler1 Euler2 Euler3", "", "", "MTEX, loadEBSD_ctf.m", "crystal to sample"},
    {"ang", "tsl edax oim", "euler:ZXZ", "phi1 PHI phi2", "", "", "MTEX, loadEBSD_ang.m", "crystal to sample; points that were not indexed have 4 pi"},
    {"matthies", "", "euler:ZYZ", "alpha beta gamma", "", "", "MTEX, euler2quat.m", "crystal to sample"},
    {"roe", "", "euler:ZYZ", "Psi Theta Phi", "", "", "MTEX, euler2quat.m", "crystal to sample"},
    {"kocks", "", "", "", "", "", "MTEX, euler2quat.m", "no SPEC has its angles: they are matthies' with gamma = pi - phi"},
    {"canova", "", "", "", "", "", "MTEX, euler2quat.m", "no SPEC has its angles: they are matthies' with alpha = pi/2 - omega and gamma = 3 pi/2 - phi"},
    {"relion", "xmipp spider", "euler:ZYZ:passive:deg", "rot tilt psi", "", "", "RELION, src/euler.cpp", "map to image"},
    {"cryosparc", "", "rotvec:passive", "", "", "", "pyem, geom/convert.py", "alignments3D/pose; RELION's angles: -t relion"},
    {"eman2", "eman", "euler:ZXZ:passive:deg", "az alt phi", "", "", "EMAN2, libEM/transform.cpp", "az is rot + 90, phi is psi - 90 of RELION"},
    {"dynamo", "", "euler:zxz:passive:deg", "tdrot tilt narot", "", "", "eulerangles, constants.py", ""},
    // medicine and sensors
    {"dicom", "ImageOrientationPatient iop", "6d", "", "", "", "DICOM PS3.3, C.7.6.2.1.1", "the row's direction, then the column's; reference axes are left, posterior, superior"},
    {"nifti", "qform quatern", "quat", "a b c d", "", "", "nifti1.h", "the file has b c d: put a = sqrt(1 - b^2 - c^2 - d^2) first; reference axes are right, anterior, superior"},
    {"itk", "ants simpleitk", "euler:ZXY Euler3DTransform x y z: with --columns 3,1,2; rpy Euler3DTransform with ComputeZYX; dcm the first nine of AffineTransform", "", "", "", "ITK, itkEuler3DTransform.hxx", "reference axes are left, posterior, superior"},
    {"opensim", "", "euler:XYZ orientation of .osim; rpy sensor_to_opensim_rotations; quat .sto", "", "", "", "OpenSim, OffsetFrame.h, IMUPlacer.h", "a .sto has four numbers in one field: with tabs for its commas, columns 2-5 are the first sensor's"},
    {"xsens", "mti mtw movella", "quat q0 q1 q2 q3; rpy:deg; dcm:col MT Manager", "", "enu", "", "Xsens, MTi user manual MT0605P", ""},
    {"ngimu", "", "quat:passive; dcm; rpy:deg", "", "nwu", "", "NGIMU-Software-Public, Quaternion.cs", ""},
    {"fusion", "imufusion x-imu3", "quat; rpy:deg", "", "nwu", "", "x-io Fusion, FusionMath.h", ""},
    {"android", "sensor-logger", "quat:xyzw TYPE_ROTATION_VECTOR; euler:-Z-XY getOrientation: azimuth, pitch, roll; dcm getRotationMatrix", "", "enu", "rfu", "SensorManager.java; Sensor Logger, COORDINATES.md", "Sensor Logger's quaternion: by name; its angles on iOS: euler:ZXY of yaw, pitch, roll"},
    {"coremotion", "ios cmattitude iphone apple", "quat:xyzw CMQuaternion; euler:ZXY yaw, pitch, roll; dcm:passive CMRotationMatrix", "", "", "rfu", "SGMotionSensor.m, HOCARView.m; stackoverflow.com 10827401", ""},
    {"vicon", "nexus", "quat:xyzw; euler:XYZ EulerXYZ; rotvec helical; dcm", "", "", "", "Vicon DataStream SDK, ClientUtils.cpp", "joint angles of Plug-in Gait are no attitude: they have signs and offsets"},
    {"qualisys", "qtm", "euler:XYZ:deg roll, pitch, yaw, as its standard; dcm:col rotation matrix of the real-time protocol", "", "", "", "Qualisys, Rotation angles in QTM; qualisys_drone_sdk, qfly/pose.py", "QTM can define the angles in other ways"},
    {"optitrack", "motive", "quat:xyzw", "", "", "", "Motive, Data Export: CSV", "y is up; Euler angles are in the order chosen on export"},
    {"rokoko", "", "quat:xyzw", "w x y z", "ruf", "ruf", "Rokoko, CSV Export", "left-handed"},
    {"apdm", "opal", "", "", "", "", "OpenSim, APDMDataReader.cpp", "no source found for the direction; often meant: quat (w x y z)"},
});
// clang-format on

/// Rows of files: the project, the numbers of the SPEC, the fields, the columns.
struct FileRows {
    std::string_view project;
    std::size_t size;
    std::size_t fields;
    std::string_view columns;
};
constexpr auto file_rows = std::to_array<FileRows>({
    {"tum", 4, 8, "5-8"},
    {"euroc", 4, 8, "5-8"},
    {"euroc", 4, 17, "5-8"},
    {"kitti", 9, 12, "1-3,5-7,9-11"},
    {"kitti", 3, 30, "4-6"},
    {"colmap", 4, 10, "2-5"},
    {"g2o", 4, 9, "6-9"},
    {"sdf", 3, 6, "4-6"},
    {"ang", 3, 10, "1-3"},
    {"abb", 4, 17, "4-7"}, // a robtarget
    {"openvr", 9, 12, "1-3,5-7,9-11"},
    {"franka", 9, 16, "1-3,5-7,9-11"},
    {"gltf", 9, 16, "1-3,5-7,9-11"},
    {"arkit", 9, 16, "1-3,5-7,9-11"},
    {"nerfstudio", 9, 16, "1-3,5-7,9-11"},
    {"kalibr", 9, 16, "1-3,5-7,9-11"},
});

/// The robots of the table, whose poses are a position and then the numbers of the SPEC.
constexpr std::string_view first_robot = "kuka";
constexpr std::string_view last_robot = "ur";

constexpr auto preset_count =
    static_cast<std::size_t>(std::ranges::find(project_table, "opk", &Project::text) - project_table.begin()) + 1;

} // namespace

std::span<const Project> projects() noexcept { return project_table; }

std::span<const Project> presets() noexcept { return std::span(project_table).first(preset_count); }

const Project* find_project(std::string_view name) noexcept {
    const std::string wanted = plain_name(name);
    const auto* const found = std::ranges::find_if(project_table, [&wanted](const Project& each) {
        const std::string others = ' ' + plain_name(each.others) + ' ';
        return plain_name(each.text) == wanted || others.find(' ' + wanted + ' ') != std::string::npos;
    });
    return wanted.empty() || found == project_table.end() ? nullptr : found;
}

std::string columns_in_rows(const Project& project, std::size_t size, std::size_t fields) {
    const auto* const found = std::ranges::find_if(file_rows, [&](const FileRows& each) {
        return each.project == project.text && each.size == size && each.fields == fields;
    });
    if (found != file_rows.end()) {
        return std::string(found->columns);
    }
    const auto* const first = find_project(first_robot);
    const bool is_robot = &project >= first && &project <= find_project(last_robot);
    return is_robot && fields == size + 3 ? "4-" + std::to_string(fields) : "";
}

} // namespace rotconv
