// Modes of all components, packed and numbered.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/modes_table.hpp"

#include <algorithm>
#include <bit>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::ModeId;

ModesTable::ModesTable(const automata::Plant& plant) : slots_(64, empty) {
  std::uint32_t word = 0;
  std::uint32_t used = 0;
  for (const automata::Component& component : plant.components) {
    const auto width = static_cast<std::uint32_t>(std::bit_width(component.modes.size() - 1));
    if (used + width > 64) {
      ++word;
      used = 0;
    }
    fields_.push_back({word, used % 64, (std::uint64_t{1} << width) - 1});
    used += width;
  }
  width_ = word + 1;
}

std::size_t ModesTable::slot_of(const std::uint64_t* words) const {
  std::uint64_t hash = 0x9e3779b97f4a7c15u;
  for (std::size_t w = 0; w < width_; ++w) {
    hash = (hash ^ words[w]) * 0xbf58476d1ce4e5b9u;
    hash ^= hash >> 31;
  }
  std::size_t slot = hash & (slots_.size() - 1);
  while (slots_[slot] != empty && !std::equal(words, words + width_, &words_[slots_[slot] * width_])) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slot;
}

void ModesTable::grow() {
  slots_.assign(slots_.size() * 2, empty);
  for (std::size_t row = 0; row < size_; ++row) {
    slots_[slot_of(&words_[row * width_])] = static_cast<std::uint32_t>(row);
  }
}

std::size_t ModesTable::write(const automata::Modes& modes) {
  const std::size_t row = size_ * width_;
  words_.resize(row);
  words_.resize(row + width_, 0);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    words_[row + fields_[c].word] |= std::uint64_t{modes[c].value} << fields_[c].shift;
  }
  return slot_of(&words_[row]);
}

std::uint32_t ModesTable::intern(const automata::Modes& modes) {
  if (2 * size_ >= slots_.size()) grow();
  const std::size_t slot = write(modes);
  if (slots_[slot] != empty) return slots_[slot];
  CHECK(size_ < empty && "more situations than there are numbers");
  slots_[slot] = static_cast<std::uint32_t>(size_);
  return static_cast<std::uint32_t>(size_++);
}

void ModesTable::read(std::uint32_t position, automata::Modes& modes) const {
  modes.resize(fields_.size());
  const std::uint64_t* row = &words_[position * width_];
  for (std::size_t c = 0; c < modes.size(); ++c) {
    modes[c] = ModeId((row[fields_[c].word] >> fields_[c].shift) & fields_[c].mask);
  }
}

}  // namespace rmpl::verifier
