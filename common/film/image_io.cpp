#include "common/film/image_io.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "common/base/error.h"
#include "common/film/atomic_file.h"
#include "common/trace/options.h"

namespace twintrace {
namespace {

const std::string kPrefix = "twintrace:";

// Runs that are equal must write equal bytes, so the time of writing is left out of the files.
constexpr const char* kFixedTime = "1970:01:01 00:00:00";

/// A view of one channel of the content: values at a stride.
struct ChannelView {
  std::string name;
  const float* values;
  std::size_t stride;
};

void addRgb(std::vector<ChannelView>& views, const std::string& prefix, const Image& image) {
  const char* names[3] = {"R", "G", "B"};
  for (std::size_t i = 0; i < 3; ++i) views.push_back({prefix + names[i], image.rgb.data() + i, 3});
}

std::vector<ChannelView> channelsOf(const ExrContent& content) {
  std::vector<ChannelView> views;
  addRgb(views, "", content.image);
  if (!content.variance.empty()) addRgb(views, "Variance.", content.variance);
  if (!content.count.empty()) views.push_back({"count", content.count.data(), 1});
  for (const NamedChannel& channel : content.extra) {
    views.push_back({channel.name, channel.values.data(), 1});
  }
  return views;
}

[[noreturn]] void failToWrite(const std::string& path, std::string reason) {
  if (reason.empty()) reason = OIIO::geterror();
  throw IoError(path + ": cannot be written: " + reason);
}

[[noreturn]] void failToRead(const std::string& path, std::string reason) {
  if (reason.empty()) reason = OIIO::geterror();
  throw IoError(path + ": cannot be read: " + reason);
}

[[noreturn]] void failContent(const std::string& path, const std::string& message) {
  throw FileError({Diagnostic{SourceLocation{path}, message}});
}

/// Opens an output, lets `writeRow(output, y)` write each row and gives the file its name.
template <class WriteRow>
void writeFile(const std::string& path, const OIIO::ImageSpec& spec, const WriteRow& writeRow) {
  AtomicFile file(path);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file.partialPath());
  if (!output) failToWrite(path, "");
  if (!output->open(file.partialPath(), spec)) failToWrite(path, output->geterror());
  for (int y = 0; y < spec.height; ++y) {
    if (!writeRow(*output, y)) failToWrite(path, output->geterror());
  }
  if (!output->close()) failToWrite(path, output->geterror());
  file.commit();
}

OIIO::ImageSpec exrSpec(const ExrContent& content, const std::vector<ChannelView>& channels) {
  OIIO::ImageSpec spec(content.image.width, content.image.height, static_cast<int>(channels.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const ChannelView& channel : channels) spec.channelnames.push_back(channel.name);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", kFixedTime);
  for (const auto& [key, value] : content.metadata) spec.attribute(kPrefix + key, value);
  return spec;
}

std::unique_ptr<OIIO::ImageInput> openInput(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) failToRead(path, "no such file");
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  if (!input) failToRead(path, "");
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || std::int64_t{spec.width} * spec.height > kMaxPixels) {
    failContent(path, "found " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                          " pixels, expected at most " + std::to_string(kMaxPixels) + " pixels");
  }
  return input;
}

/// Indices of R, G and B: by name, else the first three channels, else the first one thrice.
std::array<int, 3> rgbChannels(const OIIO::ImageSpec& spec) {
  const std::array<int, 3> named = {spec.channelindex("R"), spec.channelindex("G"),
                                    spec.channelindex("B")};
  if (named[0] >= 0 && named[1] >= 0 && named[2] >= 0) return named;
  if (spec.nchannels >= 3) return {0, 1, 2};
  return {0, 0, 0};
}

/// All values of an image, channels interleaved: read at once, since each reading decodes the file.
class Pixels {
 public:
  Pixels(OIIO::ImageInput& input, const std::string& path)
      : width_(input.spec().width),
        height_(input.spec().height),
        channelCount_(static_cast<std::size_t>(input.spec().nchannels)) {
    values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                   channelCount_);
    const int last = input.spec().nchannels;
    if (!input.read_image(0, 0, 0, last, OIIO::TypeDesc::FLOAT, values_.data()))
      failToRead(path, input.geterror());
  }

  std::vector<float> channel(int channel) const {
    std::vector<float> values;
    values.reserve(values_.size() / channelCount_);
    for (std::size_t i = static_cast<std::size_t>(channel); i < values_.size();
         i += channelCount_) {
      values.push_back(values_[i]);
    }
    return values;
  }

  Image rgb(const std::array<int, 3>& channels) const {
    Image image(width_, height_);
    for (std::size_t pixel = 0; pixel < image.pixelCount(); ++pixel) {
      for (std::size_t i = 0; i < 3; ++i) {
        image.rgb[pixel * 3 + i] =
            values_[pixel * channelCount_ + static_cast<std::size_t>(channels[i])];
      }
    }
    return image;
  }

 private:
  int width_;
  int height_;
  std::size_t channelCount_;
  std::vector<float> values_;
};

FilmMetadata metadataOf(const OIIO::ImageSpec& spec) {
  FilmMetadata metadata;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (name.starts_with(kPrefix)) metadata[name.substr(kPrefix.size())] = attribute.get_string();
  }
  return metadata;
}

}  // namespace

ExrContent exrContent(const Film& film) {
  ExrContent content{film.mean(), film.variance(), film.count(), {}, film.data().metadata};
  content.metadata["passes"] = std::to_string(film.passes());
  content.metadata["samples"] = film.data().ranges.toString();
  return content;
}

void writeExr(const std::string& path, const ExrContent& content) {
  const std::vector<ChannelView> channels = channelsOf(content);
  const auto width = static_cast<std::size_t>(content.image.width);
  std::vector<float> row(width * channels.size());
  const auto writeRow = [&](OIIO::ImageOutput& output, int y) {
    const std::size_t first = static_cast<std::size_t>(y) * width;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      for (std::size_t x = 0; x < width; ++x) {
        row[x * channels.size() + i] = channels[i].values[(first + x) * channels[i].stride];
      }
    }
    return output.write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data());
  };
  writeFile(path, exrSpec(content, channels), writeRow);
}

ExrContent readExr(const std::string& path) {
  const std::unique_ptr<OIIO::ImageInput> input = openInput(path);
  const OIIO::ImageSpec spec = input->spec();
  const std::array<int, 3> rgb = rgbChannels(spec);
  const std::array<int, 3> variance = {spec.channelindex("Variance.R"),
                                       spec.channelindex("Variance.G"),
                                       spec.channelindex("Variance.B")};
  const bool hasVariance = *std::min_element(variance.begin(), variance.end()) >= 0;
  ExrContent content;
  const Pixels pixels(*input, path);
  content.image = pixels.rgb(rgb);
  if (hasVariance) content.variance = pixels.rgb(variance);
  for (int i = 0; i < spec.nchannels; ++i) {
    const auto isIn = [i](const std::array<int, 3>& set) {
      return std::find(set.begin(), set.end(), i) != set.end();
    };
    if (isIn(rgb) || (hasVariance && isIn(variance))) continue;
    const std::string name = spec.channel_name(i);
    if (name == "count")
      content.count = pixels.channel(i);
    else
      content.extra.push_back({name, pixels.channel(i)});
  }
  content.metadata = metadataOf(spec);
  return content;
}

Image readLinearImage(const std::string& path) {
  const std::unique_ptr<OIIO::ImageInput> input = openInput(path);
  if (!input->spec().format.is_floating_point()) {
    failContent(path, std::string("found an image of ") + input->spec().format.c_str() +
                          ", expected linear floats (EXR or HDR)");
  }
  return Pixels(*input, path).rgb(rgbChannels(input->spec()));
}

std::uint8_t srgbCode(float linear) {
  const double value = linear > 0.0f ? std::min(double(linear), 1.0) : 0.0;
  const double coded =
      value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(coded * 255.0));
}

DisplayImage toDisplay(const Image& image) {
  DisplayImage display{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size())};
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const float* value = &image.rgb[i];
    const bool hasNan = std::isnan(value[0]) || std::isnan(value[1]) || std::isnan(value[2]);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      display.rgb[i + channel] =
          hasNan ? static_cast<std::uint8_t>(channel == 1 ? 0 : 255) : srgbCode(value[channel]);
    }
  }
  return display;
}

void writePng(const std::string& path, const DisplayImage& image) {
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  const std::size_t rowSize = static_cast<std::size_t>(image.width) * 3;
  writeFile(path, spec, [&](OIIO::ImageOutput& output, int y) {
    return output.write_scanline(y, 0, OIIO::TypeDesc::UINT8,
                                 &image.rgb[static_cast<std::size_t>(y) * rowSize]);
  });
}

void writePng(const std::string& path, const Image& image) {
  writePng(path, toDisplay(image));
}

std::string imageLibraryVersion() {
  return OIIO_VERSION_STRING;
}

}  // namespace twintrace
