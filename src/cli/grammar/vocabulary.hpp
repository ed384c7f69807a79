#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

/// The words of attitudes as text, and what they and the labels made of them say.
namespace rotconv::cli {

/// Words of a kind, each between blanks; some mean several things.
namespace vocabulary {
inline constexpr std::string_view heading = " rotation orientation attitude in is at the 3x3 4x4 ";
/// Before a name.
inline constexpr std::string_view declaration =
    " decl local const pers e6pos frame pos robtarget auto var float double int "
    "quatf quatd matrix4d matrix3d float3 double3 ";
/// Before a bracket.
inline constexpr std::string_view container = " array asarray matrix vector tensor list tuple point rotation transform "
                                              "pose float double int p ";
/// A container of a quaternion whose scalar is the last.
inline constexpr std::string_view container_xyzw = " from_quat tf::quaternion tf2::quaternion ";
/// A container of a matrix that is listed by columns.
inline constexpr std::string_view container_columns = " simd_float simd_double ";
/// The label of something that is not a number; in XML also the name of such an attribute.
inline constexpr std::string_view text_key = " dtype device layout requires_grad grad_fn frame_id child_frame_id ";
inline constexpr std::string_view xml_key = " name type class frame relative_to ";
inline constexpr std::string_view truth = " true false yes no none null ";
inline constexpr std::string_view degrees = " deg degree degrees \u00B0 ";
inline constexpr std::string_view radians = " rad radian radians ";
inline constexpr std::string_view length = " mm cm m in ";
/// At the end of a label whose numbers are not read.
inline constexpr std::string_view aside =
    " position translation pos xyz origin scale center size t tvec time covariance angular linear omega gyro gyr ";
/// As a part of such a label, and as the beginning or the end of a part.
inline constexpr std::string_view aside_anywhere = " dot sp des desired ";
inline constexpr std::string_view aside_beginning =
    " rate speed spd dps vel acc std sigma cov var err cmd setpoint target ref delta reset offset bias ";
/// The label of a number that is not one of the attitude.
inline constexpr std::string_view size = " rows cols ";
/// A part of a label that says that something is done to the numbers.
inline constexpr std::string_view operation =
    " inv inverse inverted conj conjugate transpose transposed neg negative minus ";
/// A name that does not contradict another.
inline constexpr std::string_view open_name = " matrix euler ";
/// At the end of a label of an attitude.
inline constexpr std::string_view attitude = " rotation orientation attitude rot ori ";
/// The label of one number.
inline constexpr std::string_view number_of_a_set = " w x y z i j k ";
/// Before x, y and z.
inline constexpr std::string_view vector_of_angles = " r rot rotvec rvec angle ";
} // namespace vocabulary

/// Whether the word, in any case, is one of these, which have blanks around each.
[[nodiscard]] bool is(std::string_view words, std::string_view word);

/// deg, rad, m for any length, or empty.
[[nodiscard]] std::string_view unit_of_word(std::string_view word);

/// What a word says of numbers: deg, rad, xyzw, wxyz, ypr, a modifier, a sequence or a name of a representation; or
/// empty. Case counts in a sequence alone.
[[nodiscard]] std::string convention_in(std::string_view word);

/// The representation that a word names, in any case and with what programs put around it, as Quaterniond or from_quat.
[[nodiscard]] std::optional<RepresentationId> named_representation(std::string_view word);

/// What is left without digits and the letters of a type behind them: Matrix3d, Vector4f, Matrix3x3.
[[nodiscard]] std::string_view without_type(std::string_view word);

/// The words of a label: they end at _ . : blanks and where upper case begins.
[[nodiscard]] std::vector<std::string> parts_of_label(std::string_view label);

/// deg or rad at the end of a label, or empty: roll_deg, "yaw [rad]", rollDeg.
[[nodiscard]] std::string unit_in(const std::string& label);
/// The words of convention at the end of a label.
[[nodiscard]] std::vector<std::string> conventions_in(const std::string& label);
/// The last part of a label that is not a unit or an order.
[[nodiscard]] std::string name_in(const std::string& label);

/// Whether a label says that something is done to the numbers: q_inv, R.T.
[[nodiscard]] bool is_operation(std::string_view label);
/// Whether a label is that of rates, deviations, commands and the like.
[[nodiscard]] bool is_derived(const std::string& label);
/// Whether the numbers under a label are never those of the attitude.
[[nodiscard]] bool is_aside(const std::string& label);

} // namespace rotconv::cli
