#include "plugin/page/comparison_page.h"

#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <string_view>
#include <utility>

#include "colmap_io/files/lower_extension.h"
#include "core/base/check_option.h"
#include "core/base/error.h"
#include "plugin/page/page_assets.h"
#include "plugin/page/page_blobs.h"
#include "plugin/page/page_photographs.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

std::string ReadThreeJs(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || text.str().empty()) {
    throw InputError(
        fmt::format("html_path: the page needs {}, which cannot be read; "
                    "Debian's package libjs-three has it",
                    path.string()));
  }
  return text.str();
}

// As the content of a script element, which "</" would end.
std::string ScriptJson(const Json& json) {
  const std::string text =
      json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string_view Asset(std::string_view name) {
  for (const PageAsset& asset : PageAssets()) {
    if (asset.name == name) {
      return asset.text;
    }
  }
  throw InvariantError(fmt::format("no page asset {}", name));
}

// "up": the mean of the cameras' upward directions; "front": where the first
// one stands.
void AddOrientation(const std::vector<Rigid3d>& cameras, Json* json) {
  if (cameras.empty()) {
    return;
  }
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (const Rigid3d& cam_from_world : cameras) {
    up -= cam_from_world.rotation.row(1).transpose() / double(cameras.size());
  }
  const Eigen::Vector3d front = cameras.front().Inverse().translation;
  (*json)["up"] = VectorToJson(up);
  (*json)["front"] = VectorToJson(front);
}

Json PageToJson(const ComparisonPage& page, PageBlobs* blobs) {
  Json json;
  json["title"] = page.title;
  json["has_truth"] = page.has_truth;
  json["diagonal"] = page.diagonal;
  json["compared_with"] = page.compared_with;
  AddOrientation(page.cameras, &json);
  json["procedure"] = page.procedure;
  json["command_line"] = page.command_line;
  json["meshes"] = Json::array();
  for (const PageMesh& mesh : page.meshes) {
    json["meshes"].push_back(PageMeshToJson(mesh, blobs));
  }
  return json;
}

void WriteScript(std::ostream& stream,
                 std::string_view attributes,
                 std::string_view text) {
  stream << "<script" << attributes << ">" << text << "</script>\n";
}

// The marks of page.html are comments of their own lines: <!-- styles -->.
void WriteFilled(
    std::string_view text,
    const std::vector<std::pair<std::string_view, std::function<void()>>>&
        marks,
    std::ostream& stream) {
  for (const auto& [mark, write] : marks) {
    const size_t at = text.find(mark);
    if (at == std::string_view::npos) {
      throw InvariantError(fmt::format("page.html lacks {}", mark));
    }
    stream << text.substr(0, at);
    write();
    text.remove_prefix(at + mark.size());
  }
  stream << text;
}

}  // namespace

fs::path ThreeJsPath() { return "/usr/share/javascript/three/three.min.js"; }

void CheckPagePath(const fs::path& html_path,
                   FileRoles* files,
                   const fs::path& three_js) {
  if (html_path.empty()) {
    return;
  }
  const std::string extension = LowerExtension(html_path);
  CheckOption(extension == ".html" || extension == ".htm",
              "html_path",
              html_path.string(),
              "must end with .html or .htm");
  files->Write("html_path", html_path, "the page");
  ReadThreeJs(three_js);
}

void WriteComparisonPage(const fs::path& html_path,
                         const ComparisonPage& page,
                         const std::vector<View>& photographs,
                         const Context& context,
                         AtomicFiles* files) {
  const Phase phase(context, "HTML page");
  const std::string three_js = ReadThreeJs(ThreeJsPath());
  PageBlobs blobs;
  Json json = PageToJson(page, &blobs);
  json["num_views"] = photographs.size();
  json["photographs"] = PagePhotographsToJson(photographs, context, &blobs);
  files->Write(html_path, [&](std::ostream& stream) {
    const auto write_styles = [&] {
      stream << "<style>\n" << Asset("style.css") << "</style>\n";
    };
    const auto write_data = [&] {
      WriteScript(stream,
                  " type=\"application/json\" id=\"report\"",
                  ScriptJson(page.report));
      WriteScript(
          stream, " type=\"application/json\" id=\"page\"", ScriptJson(json));
      for (size_t i = 0; i < blobs.Texts().size(); ++i) {
        WriteScript(stream,
                    fmt::format(" type=\"text/plain\" id=\"blob-{}\"", i),
                    blobs.Texts()[i]);
      }
    };
    const auto write_scripts = [&] {
      WriteScript(stream, "", three_js);
      for (const PageAsset& asset : PageAssets()) {
        if (asset.name.ends_with(".js")) {
          WriteScript(stream, "", asset.text);
        }
      }
    };
    WriteFilled(Asset("page.html"),
                {{"<!-- styles -->", write_styles},
                 {"<!-- data -->", write_data},
                 {"<!-- scripts -->", write_scripts}},
                stream);
  });
}

}  // namespace octacut
