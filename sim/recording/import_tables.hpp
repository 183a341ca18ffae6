#pragma once

#include "sim/recording/csv_rows.hpp"
#include "sim/recording/labels.hpp"
#include "sim/recording/uart_stream.hpp"

namespace specula {

/// Range profiles of a serial stream as features, and the sensor's own answers.
/// @out  one line for what was passed over, if anything was
/// Throws InputError where there is no packet with a range profile, or with the byte of the packet
/// whose profile or answer has another length than the first one's.
std::vector<std::string> take_uart(const UartStream& stream, Dataset& dataset);

/// The number of every frame of a dataset, as text.
std::vector<std::string> frame_numbers(const Dataset& dataset);

/// Features of a table; its label columns are the manifest's, or those called class, world, sample,
/// session, view and frame.
/// Throws InputError with the byte of a cell that is no number.
LabelColumns take_csv(const CsvRows& table, const RecordingManifest& manifest, Dataset& dataset);

}  // namespace specula
