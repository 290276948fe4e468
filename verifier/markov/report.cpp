// Probabilities in words and numbers.
// SPDX-License-Identifier: MIT
#include "verifier/markov/report.hpp"

#include <cmath>
#include <cstdio>

#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(const Enclosure& bounds) {
  const auto [lower, upper] = as_doubles(bounds);
  return {{"lower", lower}, {"upper", upper}};
}

ordered_json json_of(const MeanTime& mean) {
  if (mean.infinite) return {{"lower", nullptr}, {"upper", nullptr}};
  return json_of(mean.seconds);
}

ordered_json curve_json(const Likelihood& one) {
  ordered_json result = ordered_json::array();
  for (const auto& [time, probability] : one.curve) {
    ordered_json point = {{"time", time.seconds()}};
    point.update(json_of(probability));
    result.push_back(std::move(point));
  }
  return result;
}

/// `min` and `max`, where there are two, or neither name.
template <class Visit>
void for_each_likelihood(const ProbabilityAnswer& answer, const Visit& visit) {
  if (answer.only) visit("", *answer.only);
  if (answer.least) visit("min", *answer.least);
  if (answer.greatest) visit("max", *answer.greatest);
}

/// Where nothing is known above, it may be infinite for all that is known.
std::string time_text(const Enclosure& seconds) {
  const auto [lower, upper] = as_doubles(seconds);
  return std::isinf(upper) ? "at least " + number_text(lower) + " s" : number_text(seconds) + " s";
}

std::string line_of(const std::string& name, const Likelihood& one) {
  const std::string begins = name.empty()    ? "probability: "
                             : name == "min" ? "least probability: "
                                             : "greatest probability: ";
  std::string text = begins + number_text(one.probability) + "\n";
  if (one.mean_time) {
    const std::string time = one.mean_time->infinite ? "infinite" : time_text(one.mean_time->seconds);
    text += (name.empty() ? "mean time: " : name == "min" ? "least mean time: " : "greatest mean time: ") + time + "\n";
  }
  return text;
}

}  // namespace

DoubleBounds as_doubles(const Enclosure& bounds) {
  DoubleBounds result{static_cast<double>(bounds.lower), static_cast<double>(bounds.upper)};
  if (static_cast<Real>(result.lower) > bounds.lower) result.lower = std::nextafter(result.lower, 0);
  if (static_cast<Real>(result.upper) < bounds.upper) {
    result.upper = std::nextafter(result.upper, std::numeric_limits<double>::infinity());
  }
  return result;
}

std::string number_text(const Enclosure& bounds) {
  const auto [lower, upper] = as_doubles(bounds);
  const std::string a = number_text(lower);
  const std::string b = number_text(upper);
  return a == b ? a : "between " + a + " and " + b;
}

std::string to_text(const ProbabilityQuestion& question, const ProbabilityAnswer& answer, const std::string& asked) {
  std::string text =
      asked + (question.within ? " within " + automata::format_seconds(*question.within) + " s" : " ever") +
      (question.period ? ", in steps of " + automata::format_seconds(*question.period) + " s" : ", in dense time") +
      "\n";
  if (answer.limit) return text + "undecided: " + reason(answer.limit, answer.progress) + "\n";
  for_each_likelihood(answer, [&](const std::string& name, const Likelihood& one) { text += line_of(name, one); });
  if (answer.startless) text += "no state to start in is possible\n";
  if (answer.faults_at_most) {
    text += "runs with more than " + std::to_string(*answer.faults_at_most) +
            (*answer.faults_at_most == 1 ? " fault" : " faults") +
            " were not followed: what they could add is part of the bounds\n";
  }
  if (!answer.precise) text += "the bounds are further apart than was asked for\n";
  return text;
}

ordered_json to_json(const ProbabilityQuestion& question, const ProbabilityAnswer& answer, const std::string& asked) {
  ordered_json json = {{"property", "probability"}, {"target", asked}};
  if (answer.only) json.update(json_of(answer.only->probability));
  if (answer.least) json["min"] = json_of(answer.least->probability);
  if (answer.greatest) json["max"] = json_of(answer.greatest->probability);
  if (answer.limit) {
    json["verdict"] = "undecided";
    json["reason"] = reason(answer.limit, answer.progress);
  }
  json["within"] = question.within ? ordered_json(question.within->seconds()) : ordered_json(nullptr);
  json["time"] = question.period ? ordered_json(question.period->seconds()) : ordered_json("dense");
  json["states"] = answer.progress.states;
  json["faults_at_most"] = answer.faults_at_most ? ordered_json(*answer.faults_at_most) : ordered_json(nullptr);
  if (!answer.limit) json["precise"] = answer.precise;
  if (question.mean_time && !answer.limit) {
    ordered_json& mean = json["mean_time"];
    if (answer.only) mean = {{"min", json_of(*answer.only->mean_time)}, {"max", json_of(*answer.only->mean_time)}};
    if (answer.least) mean["min"] = json_of(*answer.least->mean_time);
    if (answer.greatest) mean["max"] = json_of(*answer.greatest->mean_time);
  }
  if (question.points > 0 && !answer.limit) {
    ordered_json& curve = json["curve"];
    for_each_likelihood(answer, [&](const std::string& name, const Likelihood& one) {
      (name.empty() ? curve : curve[name]) = curve_json(one);
    });
  }
  json["statistics"] = statistics_of(answer.progress);
  return json;
}

std::string curve_csv(const ProbabilityAnswer& answer) {
  std::string text = "time";
  std::size_t points = 0;
  for_each_likelihood(answer, [&](const std::string& name, const Likelihood& one) {
    const std::string prefix = name.empty() ? "" : name + "_";
    text += "," + prefix + "lower," + prefix + "upper";
    points = one.curve.size();
  });
  text += "\n";
  for (std::size_t i = 0; i < points; ++i) {
    std::string line;
    for_each_likelihood(answer, [&](const std::string&, const Likelihood& one) {
      const auto& [time, probability] = one.curve[i];
      if (line.empty()) line = automata::format_seconds(time);
      const auto [lower, upper] = as_doubles(probability);
      line += "," + ordered_json(lower).dump() + "," + ordered_json(upper).dump();
    });
    text += line + "\n";
  }
  return text;
}

std::string curve_svg(const ProbabilityAnswer& answer, const std::string& asked) {
  constexpr double width = 640, height = 360, left = 90, bottom = 40, top = 34, right = 20;
  double most = 0;
  double last = 0;
  for_each_likelihood(answer, [&](const std::string&, const Likelihood& one) {
    for (const auto& [time, probability] : one.curve) {
      most = std::max(most, as_doubles(probability).upper);
      last = std::max(last, time.seconds());
    }
  });
  const double high = most > 0 ? most : 1;
  const double long_ = last > 0 ? last : 1;
  const auto coordinate = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return std::string(text);
  };
  const auto x = [&](double time) { return coordinate(left + (width - left - right) * time / long_); };
  const auto y = [&](double p) { return coordinate(height - bottom - (height - bottom - top) * p / high); };
  std::string title;
  for (const char c : asked) {
    title += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 360\" font-family=\"Liberation Sans, Arial, "
      "sans-serif\" "
      "font-size=\"12\">\n<rect width=\"640\" height=\"360\" fill=\"white\"/>\n<text x=\"90\" y=\"20\" "
      "font-size=\"14\">"
      "Probability of " +
      title + "</text>\n";
  text += "<path d=\"M" + x(0) + " " + y(high) + "V" + y(0) + "H" + x(long_) + "\" fill=\"none\" stroke=\"black\"/>\n";
  for (int tick = 0; tick <= 4; ++tick) {
    const double part = tick / 4.0;
    text += "<text x=\"" + coordinate(left - 6) + "\" y=\"" + y(high * part) + "\" text-anchor=\"end\">" +
            number_text(high * part) + "</text>\n";
    text += "<text x=\"" + x(long_ * part) + "\" y=\"" + coordinate(height - bottom + 18) +
            "\" text-anchor=\"middle\">" + number_text(long_ * part) + " s</text>\n";
  }
  for_each_likelihood(answer, [&](const std::string& name, const Likelihood& one) {
    std::string band;
    for (const auto& [time, probability] : one.curve) {
      band += (band.empty() ? "M" : "L") + x(time.seconds()) + " " + y(as_doubles(probability).upper);
    }
    for (auto at = one.curve.rbegin(); at != one.curve.rend(); ++at) {
      band += "L" + x(at->time.seconds()) + " " + y(as_doubles(at->probability).lower);
    }
    const std::string color = name == "max" ? "#c02020" : "#2050a0";
    text += "<path d=\"" + band + "Z\" fill=\"" + color + "\" fill-opacity=\"0.2\" stroke=\"" + color +
            "\" stroke-linejoin=\"round\"/>\n";
    if (!name.empty() && !one.curve.empty()) {
      text += "<text x=\"" + coordinate(width - right) + "\" y=\"" + y(as_doubles(one.curve.back().probability).upper) +
              "\" dy=\"-4\" text-anchor=\"end\" fill=\"" + color + "\">" + name + "</text>\n";
    }
  });
  return text + "</svg>\n";
}

}  // namespace rmpl::verifier
